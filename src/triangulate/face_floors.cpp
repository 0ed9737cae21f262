// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/face_floors.h"

#include <algorithm>

namespace mq::triangulate {

namespace {

// Tips of wings and other places that are worth their triangles have up to some ten of them.
constexpr std::size_t kFirst = 128;
constexpr std::size_t kMore = 32;
// Additions between two looks: so many, and so many times fewer than there are exempt triangles to be looked at.
constexpr std::size_t kBetweenLooks = 32;
constexpr std::size_t kLooked = 32;
constexpr double kRise = 2.0;

bool for_want_of_room(Cause cause) {
    return cause == Cause::Resolution || cause == Cause::Abandoned || cause == Cause::Crowded || cause == Cause::Fold;
}

}  // namespace

FaceFloors::FaceFloors(const Workspace& work) : work_(work) {}

double FaceFloors::of(int face) const {
    const auto found = raised_.find(face);
    return work_.shortest_allowed() * (found != raised_.end() ? found->second.factor : 1.0);
}

bool FaceFloors::too_short_to_split(int segment, double length) const {
    if (raised_.empty()) {
        return false;
    }
    const auto& uses = work_.mesh.segment(segment).uses;
    return std::any_of(uses.begin(), uses.end(), [&](const mesh::SurfaceMesh::SegmentUse& use) {
        const double floor = of(work_.mesh.face_of(mesh::SurfaceMesh::triangle_of(use.half_edge)));
        return floor > work_.shortest_allowed() && length < 2.0 * floor;
    });
}

void FaceFloors::look(std::size_t added) {
    added_ += added;
    if (added_ < std::max(kBetweenLooks, work_.exempt.size() / kLooked)) {
        return;
    }
    added_ = 0;
    std::map<int, std::size_t> given_up;
    for (const auto& [triangle, exemption] : work_.exempt) {
        if (for_want_of_room(exemption.cause) && work_.exemption_of(triangle) != nullptr) {
            ++given_up[work_.mesh.face_of(triangle)];
        }
    }
    for (const auto& [face, count] : given_up) {
        if (count > kFirst) {
            Raised& raised = raised_[face];
            if (count > std::max(kFirst, raised.most)) {
                raised.factor *= kRise;
                raised.most = count + kMore;
            }
        }
    }
}

}  // namespace mq::triangulate
