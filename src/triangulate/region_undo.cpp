// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/region_undo.h"

#include "triangulate/corner_angle.h"

namespace mq::triangulate {

void RegionUndo::about_to_remove(const std::vector<int>& triangles) {
    const mesh::SurfaceMesh& mesh = work_.mesh;
    for (const int t : triangles) {
        if (now_.erase(t) > 0) {
            continue;
        }
        removed_.push_back(t);
        sites_.push_back({mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)});
        angles_.push_back(smallest_angle(mesh, t).angle);
        const Exemption* exemption = work_.exemption_of(t);
        exemptions_.push_back(exemption != nullptr ? std::optional<Exemption>(*exemption) : std::nullopt);
    }
}

std::map<int, int> RegionUndo::undo() {
    if (removed_.empty()) {
        return {};
    }
    for (const int t : now_) {
        work_.exempt.erase(t);
    }
    const std::vector<int> again = work_.maxmin.replace({now_.begin(), now_.end()}, sites_);
    std::map<int, int> moved;
    for (std::size_t i = 0; i < again.size(); ++i) {
        moved[removed_[i]] = again[i];
        if (exemptions_[i]) {
            exemptions_[i]->stamp = work_.mesh.stamp(again[i]);
            work_.exempt[again[i]] = *exemptions_[i];
        }
    }
    return moved;
}

}  // namespace mq::triangulate
