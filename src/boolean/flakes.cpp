// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/flakes.h"

#include <cmath>
#include <iterator>
#include <map>

#include "base/disjoint_sets.h"

namespace mq::boolean {

std::size_t remove_flakes(Draft& draft, const std::set<std::int32_t>& faults, double thinnest) {
    DisjointSets<std::int32_t> components(draft.vertices.size());
    for (const Triangle& c : draft.triangles) {
        components.unite(c[0], c[1]);
        components.unite(c[0], c[2]);
    }
    struct Size {
        Vec3 origin;
        double six_volumes = 0.0;
        double two_areas = 0.0;
    };
    std::map<std::int32_t, Size> sizes;
    for (const std::int32_t t : faults) {
        const std::int32_t v = draft.triangles[static_cast<std::size_t>(t)][0];
        sizes[components.find(v)].origin = draft.vertices[static_cast<std::size_t>(v)];
    }
    for (const Triangle& c : draft.triangles) {
        const auto found = sizes.find(components.find(c[0]));
        if (found != sizes.end()) {
            const auto at = [&](std::size_t k) -> Vec3 {
                return draft.vertices[static_cast<std::size_t>(c[k])] - found->second.origin;
            };
            found->second.six_volumes += at(0).dot(at(1).cross(at(2)));
            found->second.two_areas += (at(1) - at(0)).cross(at(2) - at(0)).norm();
        }
    }
    // A slab has its area twice: thickness = 2 volume / area = 2 / 3 (six volumes) / (two areas).
    const auto thick = [&](const auto& entry) {
        return 2.0 / 3.0 * std::abs(entry.second.six_volumes) > thinnest * entry.second.two_areas;
    };
    for (auto it = sizes.begin(); it != sizes.end();) {
        it = thick(*it) ? sizes.erase(it) : std::next(it);
    }
    for (Triangle& c : draft.triangles) {
        c = sizes.count(components.find(c[0])) > 0 ? kGone : c;
    }
    return sizes.size();
}

}  // namespace mq::boolean
