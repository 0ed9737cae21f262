// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/vertex_placing.h"

#include <algorithm>
#include <limits>

#include "base/tuning.h"
#include "tetrahedralise/tuning.h"

namespace mq::tetrahedralise {

double VertexPlacing::worst_at(const Vec3& place, double enough) const {
    double worst = std::numeric_limits<double>::max();
    for (const auto& face : faces) {
        worst = std::min(worst, measure_.at(face, place));
        if (worst <= enough) {
            break;
        }
    }
    return worst;
}

bool VertexPlacing::try_place(Vec3& place, const Vec3& other, double& worst) const {
    const double enough = worst + kLeastGain * std::abs(worst);
    const double value = worst_at(other, enough);
    if (!(value > enough)) {
        return false;
    }
    const bool valid = value <= 0.0 || std::all_of(faces.begin(), faces.end(), [&](const auto& face) {
                           return orient3d(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]), other) > 0;
                       });
    if (valid) {
        worst = value;
        place = other;
    }
    return valid;
}

/// The direction in which the cells that are nearly as bad as the worst one get better.
Vec3 VertexPlacing::uphill(const Vec3& place, double worst) const {
    /// Cells within this fraction of the worst one count as well.
    constexpr double kActive = 0.1;
    Vec3 sum = Vec3::Zero();
    for (const auto& face : faces) {
        const double here = measure_.at(face, place);
        if (here > worst + kActive * std::abs(worst)) {
            continue;
        }
        const double delta = 1e-5 * (mesh_.point(face[0]) - place).norm();
        Vec3 gradient;
        for (int i = 0; i < 3; ++i) {
            Vec3 moved = place;
            moved[i] += delta;
            gradient[i] = measure_.at(face, moved) - here;
        }
        if (gradient.squaredNorm() > 0.0) {
            sum += gradient.normalized();
        }
    }
    return sum;
}

bool VertexPlacing::step(Vec3& place, double length, double& worst) const {
    const Vec3 direction = uphill(place, worst);
    const double norm = direction.norm();
    if (!(norm > 1e-9)) {
        return false;
    }
    double by = TetrahedralisationTuning::kFirstStep * length;
    for (int i = 0; i < TetrahedralisationTuning::kStepHalvings; ++i, by *= 0.4) {
        if (try_place(place, place + by / norm * direction, worst)) {
            return true;
        }
    }
    return false;
}

bool VertexPlacing::improve(Vec3& place, double& worst) const {
    double length = 0.0;
    Vec3 middle = Vec3::Zero();
    for (const auto& face : faces) {
        for (const int w : face) {
            length += (mesh_.point(w) - place).norm();
            middle += mesh_.point(w);
        }
    }
    const double count = 3.0 * static_cast<double>(faces.size());
    length /= count;
    middle /= count;
    bool any = try_place(place, middle, worst) || try_place(place, 0.5 * (place + middle), worst);
    for (int i = 0; i < TetrahedralisationTuning::kVertexSteps && step(place, length, worst); ++i) {
        any = true;
    }
    return any;
}

}  // namespace mq::tetrahedralise
