// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/face_size_floors.h"

#include <algorithm>

#include "triangulate/refine/tuning.h"

namespace mq::triangulate {

namespace {

// Insertions between two checks: at least this number, and a fraction 1 / kLooked of the exempt triangles that a check
// visits, which bounds its cost.
constexpr std::size_t kBetweenLooks = 32;
constexpr std::size_t kLooked = 32;  // Divisor of the number of exempt triangles; see above.

// Triangles that are crowded or would fold are none of these: along a narrow face many of them are given up until its
// borders have been divided, and are good afterwards.
bool for_want_of_resolution(Cause cause) {
    return cause == Cause::Resolution || cause == Cause::FaceFloorRaised;
}

}  // namespace

FaceSizeFloors::FaceSizeFloors(const Workspace& work) : work_(work) {}

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

void FaceSizeFloors::look(std::size_t added) {
    added_ += added;
    if (added_ < std::max(kBetweenLooks, work_.exempt.size() / kLooked)) {
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
