// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/face_size_floors.h"

#include <algorithm>
#include <cmath>

#include "triangulate/refine/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

namespace {

// Insertions between two checks: at least this number, and a fraction 1 / kChecked of the exempt triangles that a check
// visits, which bounds its cost.
constexpr std::size_t kBetweenChecks = 32;
constexpr std::size_t kChecked = 32;  // Divisor of the number of exempt triangles; see above.

// Triangles that are crowded or would fold are none of these: along a narrow face many of them are given up until its
// borders have been divided, and are good afterwards.
bool for_want_of_resolution(Cause cause) {
    return cause == Cause::Resolution || cause == Cause::FaceFloorRaised;
}

}  // namespace

double FaceSizeFloors::of(int face) const {
    const auto found = raised_.find(face);
    return work_.shortest_allowed() * (found != raised_.end() ? found->second.factor : 1.0);
}

bool FaceSizeFloors::too_short_to_split(int segment, double length) const {
    if (raised_.empty()) {
        return false;
    }
    const auto& uses = work_.mesh.segment(segment).uses;
    return std::any_of(uses.begin(), uses.end(), [&](const ClassifiedMesh::SegmentUse& use) {
        const double floor = of(work_.mesh.face_of(ClassifiedMesh::triangle_of(use.half_edge)));
        return floor > work_.shortest_allowed() && length < 2.0 * floor;
    });
}

bool FaceSizeFloors::joins_near_sides(int triangle) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const double least = work_.shortest_allowed() * std::tan(bound_);
    const double area = doubled_area(mesh, triangle).squaredNorm();
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (mesh.segment_of(h) >= 0 && work_.maxmin.on_border(mesh.vertex_of(ClassifiedMesh::prev(h))) &&
            area < least * least * squared_length(mesh, h)) {
            return true;
        }
    }
    return false;
}

// Where the face becomes wider, its boundary is divided further.
bool FaceSizeFloors::too_narrow(int triangle) const {
    const int h = 3 * triangle;
    const auto near = [&](int side) {
        const int g = work_.mesh.twin(side);
        return g < 0 || joins_near_sides(ClassifiedMesh::triangle_of(g));
    };
    return joins_near_sides(triangle) && near(h) && near(h + 1) && near(h + 2);
}

void FaceSizeFloors::check_after(std::size_t added) {
    added_ += added;
    if (added_ < std::max(kBetweenChecks, work_.exempt.size() / kChecked)) {
        return;
    }
    added_ = 0;
    std::map<int, std::size_t> given_up;
    for (const auto& [triangle, exemption] : work_.exempt) {
        if (for_want_of_resolution(exemption.cause) && work_.exemption_of(triangle) != nullptr) {
            ++given_up[work_.mesh.face_of(triangle)];
        }
    }
    for (const auto& [face, count] : given_up) {
        if (count > RefinementTuning::kExemptBeforeFloor) {
            Raised& raised = raised_[face];
            if (count > std::max(RefinementTuning::kExemptBeforeFloor, raised.most)) {
                raised.factor *= RefinementTuning::kFloorRise;
                raised.most = count + RefinementTuning::kExemptBetweenFloors;
                ++raises_;
            }
        }
    }
}

}  // namespace mq::triangulate
