// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/corner_table.h"

#include <algorithm>

#include "mesh/edge_buckets.h"

namespace mq::mesh {
namespace {

void match_bucket(const EdgeEntry* first, const EdgeEntry* last, std::vector<std::int32_t>& twins) {
    for (const EdgeEntry* i = first; i != last;) {
        const EdgeEntry* j = i + 1;
        while (j != last && j->high == i->high) {
            ++j;
        }
        if (j - i == 1) {
            twins[i->corner()] = kBorder;
        } else if (j - i == 2 && i[0].upward() != i[1].upward()) {
            twins[i[0].corner()] = static_cast<std::int32_t>(i[1].corner());
            twins[i[1].corner()] = static_cast<std::int32_t>(i[0].corner());
        }
        i = j;
    }
}

}  // namespace

std::vector<std::int32_t> edge_twins(const std::vector<Triangle>& triangles, std::size_t vertex_count) {
    std::vector<std::int32_t> twins(3 * triangles.size(), kIrregular);
    edge_buckets(triangles, vertex_count,
                 [&](const EdgeEntry* first, const EdgeEntry* last) { match_bucket(first, last, twins); });
    return twins;
}

VertexFans fans(const std::vector<Triangle>& triangles, const std::vector<std::int32_t>& twins) {
    VertexFans result;
    result.fan_of.assign(twins.size(), -1);
    for (std::size_t start = 0; start < twins.size(); ++start) {
        if (result.fan_of[start] >= 0) {
            continue;
        }
        const auto fan = static_cast<std::int32_t>(result.vertex_of.size());
        result.vertex_of.push_back(triangles[start / 3][start % 3]);
        // Walks once around the vertex over the edges that arrive at it; from a border it walks back over the edges
        // that leave.
        auto h = static_cast<std::int32_t>(start);
        do {
            result.fan_of[h] = fan;
            h = twins[previous_corner(h)];
        } while (h >= 0 && result.fan_of[h] < 0);
        for (h = twins[start]; h >= 0 && result.fan_of[next_corner(h)] < 0; h = twins[next_corner(h)]) {
            result.fan_of[next_corner(h)] = fan;
        }
    }
    return result;
}

Components components(const std::vector<std::int32_t>& twins) {
    Components result;
    result.component_of.assign(twins.size() / 3, -1);
    std::vector<std::int32_t> stack;
    for (std::size_t start = 0; start < result.component_of.size(); ++start) {
        if (result.component_of[start] >= 0) {
            continue;
        }
        result.component_of[start] = result.count;
        stack.push_back(static_cast<std::int32_t>(start));
        while (!stack.empty()) {
            const std::int32_t t = stack.back();
            stack.pop_back();
            for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
                if (twins[h] >= 0 && result.component_of[twins[h] / 3] < 0) {
                    result.component_of[twins[h] / 3] = result.count;
                    stack.push_back(twins[h] / 3);
                }
            }
        }
        ++result.count;
    }
    return result;
}

}  // namespace mq::mesh
