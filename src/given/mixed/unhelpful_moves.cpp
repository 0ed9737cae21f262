// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/unhelpful_moves.h"

#include <cstdint>

#include "base/disjoint_sets.h"

namespace mq::given {

std::set<std::size_t> revert_unhelpful_moves(const std::vector<ElementNodes>& elements, const std::vector<Vec3>& before,
                                             const std::vector<double>& quality_before,
                                             const std::vector<double>& quality, std::vector<Vec3>& nodes) {
    DisjointSets<std::int32_t> groups(nodes.size());
    std::vector<std::int32_t> first_changed(elements.size(), -1);
    for (std::size_t e = 0; e < elements.size(); ++e) {
        for (const std::int32_t node : elements[e].nodes) {
            const auto n = static_cast<std::size_t>(node);
            if (nodes[n] != before[n]) {
                first_changed[e] = first_changed[e] < 0 ? node : first_changed[e];
                groups.unite(first_changed[e], node);
            }
        }
    }
    std::vector<std::int64_t> gained(
        nodes.size(),
        0);  // by group: number of elements that became valid less the number that became invalid
    for (std::size_t e = 0; e < elements.size(); ++e) {
        if (first_changed[e] >= 0) {
            gained[static_cast<std::size_t>(groups.find(first_changed[e]))] +=
                (quality[e] > 0.0 ? 1 : 0) - (quality_before[e] > 0.0 ? 1 : 0);
        }
    }
    std::set<std::size_t> kept;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        if (first_changed[e] >= 0 && gained[static_cast<std::size_t>(groups.find(first_changed[e]))] > 0) {
            kept.insert(e);
        }
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (gained[static_cast<std::size_t>(groups.find(static_cast<std::int32_t>(n)))] <= 0) {
            nodes[n] = before[n];
        }
    }
    return kept;
}

}  // namespace mq::given
