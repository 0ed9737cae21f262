// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/separate_copies.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "base/angle.h"
#include "boolean/rounding/tuning.h"

namespace mq::boolean {

namespace {

/// The directions into the material that the triangles around a copy leave.
struct Surroundings {
    Vec3 against_normals = Vec3::Zero();  ///< weighted by angles
    Vec3 along_edges = Vec3::Zero();
    double angle = 0.0;  ///< sum of the angles
    double shortest = 1e300;

    Vec3 way() const {
        return against_normals.norm() < RoundingTuning::kThinWedge * angle ? along_edges.normalized()
                                                                           : against_normals.normalized();
    }
};

using Copies = std::unordered_map<std::int32_t, Surroundings>;

void measure_surroundings(const ResultMesh& draft, Copies& copies) {
    for (const Triangle& c : draft.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto found = copies.find(c[k]);
            if (found == copies.end()) {
                continue;
            }
            Surroundings& around = found->second;
            const Vec3& p = draft.vertices[static_cast<std::size_t>(c[k])];
            const Vec3 u = draft.vertices[static_cast<std::size_t>(c[(k + 1) % 3])] - p;
            const Vec3 v = draft.vertices[static_cast<std::size_t>(c[(k + 2) % 3])] - p;
            const double angle = angle_between(u, v);
            around.against_normals -= angle * u.cross(v).normalized();
            around.along_edges += u.normalized() + v.normalized();
            around.angle += angle;
            around.shortest = std::min({around.shortest, u.norm(), v.norm()});
        }
    }
}

}  // namespace

std::size_t separate_copies(Extraction& extraction, double distance, double least) {
    ResultMesh& draft = extraction.draft;
    Copies copies;
    for (const std::vector<std::int32_t>& place : extraction.copies) {
        for (std::size_t i = 1; i < place.size(); ++i) {
            copies[place[i]];
        }
    }
    if (copies.empty()) {
        return 0;
    }
    measure_surroundings(draft, copies);
    std::vector<double> moved(draft.vertices.size(), 0.0);
    for (const auto& [v, around] : copies) {
        const double length = std::max(std::min(distance, RoundingTuning::kCopyPartOfEdge * around.shortest), least);
        draft.vertices[static_cast<std::size_t>(v)] += length * around.way();
        draft.made[static_cast<std::size_t>(v)] = kConstructed;
        moved[static_cast<std::size_t>(v)] = length;
    }
    add_displacements(draft, moved);
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        for (const std::int32_t v : draft.triangles[t]) {
            if (copies.count(v) > 0) {
                draft.source[t] = Source{};
            }
        }
    }
    return copies.size();
}

}  // namespace mq::boolean
