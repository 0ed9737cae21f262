// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/degenerate_triangles.h"

namespace mq::triangulate {

namespace {

using Link = FaceMesh::Link;
using VertexUse = FaceMesh::VertexUse;

void join(std::vector<std::array<Link, 3>>& links, const Link& a, const Link& b) {
    if (a.half_edge >= 0) {
        links[a.half_edge / 3][a.half_edge % 3] = b;
    }
    if (b.half_edge >= 0) {
        links[b.half_edge / 3][b.half_edge % 3] = a;
    }
}

// Returns the sides of the triangle that are one vertex in space: none, one or all.
std::vector<int> collapsed_sides(const std::array<int, 3>& triangle, const std::vector<VertexUse>& sites) {
    std::vector<int> result;
    for (int i = 0; i < 3; ++i) {
        if (same_vertex(sites[triangle[i]], sites[triangle[(i + 1) % 3]])) {
            result.push_back(i);
        }
    }
    return result;
}

}  // namespace

std::optional<std::array<int, 2>> add_without_degenerate(const std::vector<std::array<int, 3>>& triangles,
                                                         std::vector<std::array<Link, 3>> links, FaceMesh& result) {
    std::vector<char> dropped(triangles.size(), 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const std::vector<int> collapsed = collapsed_sides(triangles[t], result.sites);
        dropped[t] = collapsed.empty() ? 0 : 1;
        if (collapsed.size() != 1) {
            continue;  // the triangles beside one that is all one vertex are dropped, too: nothing is to be joined
        }
        const Link a = links[t][(collapsed.front() + 1) % 3];
        const Link b = links[t][(collapsed.front() + 2) % 3];
        if (a.half_edge < 0 && b.half_edge < 0) {
            return std::array<int, 2>{a.border, b.border};
        }
        join(links, a, b);
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const Link& link : links[t]) {
            if (!dropped[t] && link.half_edge < 0 && result.borders[link.border].index < 0) {
                return std::array<int, 2>{link.border, link.border};
            }
        }
    }
    std::vector<int> number(triangles.size(), -1);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (!dropped[t]) {
            number[t] = static_cast<int>(result.triangles.size());
            result.triangles.push_back(triangles[t]);
            result.links.push_back(links[t]);
        }
    }
    for (auto& sides : result.links) {
        for (Link& link : sides) {
            if (link.half_edge >= 0) {
                link.half_edge = 3 * number[link.half_edge / 3] + link.half_edge % 3;
            }
        }
    }
    return std::nullopt;
}

}  // namespace mq::triangulate
