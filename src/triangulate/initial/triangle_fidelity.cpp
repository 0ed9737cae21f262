// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/triangle_fidelity.h"

#include <algorithm>

#include "triangulate/initial/tuning.h"

namespace mq::triangulate {

TriangleFault fault_of(const TriangleOnFace& triangle) {
    const auto& s = triangle.corners;
    const Vec3 along = s[1]->point - s[0]->point;
    const Vec3 across = s[2]->point - s[1]->point;
    const double longest = std::max({along.norm(), across.norm(), (s[0]->point - s[2]->point).norm()});
    Vec3 own = (triangle.reversed ? -1.0 : 1.0) * along.cross(across);
    const double height = own.norm() / longest;
    if (height < triangle.least_height) {
        return TriangleFault::None;
    }
    own.normalize();
    double worst = own.dot(triangle.surface_normal);
    double best = worst;
    bool singular = false;
    for (const FaceMesh::VertexUse* corner : s) {
        if (corner->normal.squaredNorm() > 0.0) {
            worst = std::min({worst, own.dot(corner->normal), triangle.surface_normal.dot(corner->normal)});
            best = std::max(best, own.dot(corner->normal));
        } else {
            singular = true;
        }
    }
    const Vec3 away = triangle.on_surface - (s[0]->point + s[1]->point + s[2]->point) / 3.0;
    double sag = std::abs(own.dot(away));
    // Beside a long chord of a curved border the surface deviates along its own normal.
    if (worst < kCosMaxTurnAtApex) {
        sag = std::max(sag, std::abs(triangle.surface_normal.dot(away)));
    }
    const bool upside_down = (singular ? worst : best) < 0.0;  // the triangle lies beyond such a chord
    if (upside_down || (!singular && sag > InitialTuning::kMaxSag * height && sag > triangle.sag_that_counts)) {
        return TriangleFault::ChordDeviation;
    }
    return worst < (singular ? kCosMaxTurnAtApex : kCosMaxTurn) ? TriangleFault::NormalDeviation : TriangleFault::None;
}

}  // namespace mq::triangulate
