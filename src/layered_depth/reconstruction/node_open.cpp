// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/node_open.h"

#include <algorithm>
#include <array>
#include <utility>

#include "layered_depth/reconstruction/border_stitching.h"
#include "layered_depth/reconstruction/directed_edge_set.h"
#include "mesh/corner_table.h"

namespace mq::layered_depth {

std::vector<std::int32_t> open_nodes(std::vector<Vec3>& points, std::vector<mesh::Triangle>& triangles,
                                     const std::vector<std::uint8_t>& candidate) {
    const mesh::VertexFans fans = mesh::fans(triangles, mesh::edge_twins(triangles, points.size()));
    std::vector<std::array<std::int32_t, 2>> opened;  // points to be examined, with their fans
    for (std::size_t f = 0; f < fans.vertex_of.size(); ++f) {
        if (candidate[fans.vertex_of[f]] != 0) {
            opened.push_back({fans.vertex_of[f], static_cast<std::int32_t>(f)});
        }
    }
    std::sort(opened.begin(), opened.end());
    std::vector<std::int32_t> point_of = fans.vertex_of;
    std::vector<std::int32_t> originals;
    for (std::size_t k = 1; k < opened.size(); ++k) {
        const auto [p, fan] = opened[k];
        if (p == opened[k - 1][0]) {
            const Vec3 copy = points[p];
            point_of[fan] = static_cast<std::int32_t>(points.size());
            points.push_back(copy);
            originals.push_back(p);
        }
    }
    for (std::size_t corner = 0; corner < fans.fan_of.size(); ++corner) {
        triangles[corner / 3][corner % 3] = point_of[fans.fan_of[corner]];
    }
    return originals;
}

void separate_nodes(std::vector<Vec3>& points, const std::vector<mesh::Triangle>& triangles,
                    const std::vector<std::int32_t>& source, const std::vector<std::int32_t>& originals,
                    std::int32_t first_copy, double distance) {
    struct Around {
        Vec3 sum = Vec3::Zero();
        int count = 0;
        bool fixed = false;
    };
    std::vector<std::int32_t> place(points.size(), -1);
    std::vector<std::int32_t> moving;
    const auto note = [&](std::int32_t p) {
        if (place[p] < 0) {
            place[p] = static_cast<std::int32_t>(moving.size());
            moving.push_back(p);
        }
    };
    for (std::size_t k = 0; k < originals.size(); ++k) {
        note(originals[k]);
        note(first_copy + static_cast<std::int32_t>(k));
    }
    std::vector<Around> around(moving.size());
    for (std::size_t k = 0; k < triangles.size() && !moving.empty(); ++k) {
        for (int i = 0; i < 3; ++i) {
            if (place[triangles[k][i]] >= 0) {
                Around& at = around[place[triangles[k][i]]];
                at.sum += points[triangles[k][(i + 1) % 3]] + points[triangles[k][(i + 2) % 3]];
                at.count += 2;
                at.fixed = at.fixed || source[k] >= 0;
            }
        }
    }
    for (std::size_t k = 0; k < moving.size(); ++k) {
        if (around[k].count > 0 && !around[k].fixed) {
            Vec3& p = points[moving[k]];
            const Vec3 way = around[k].sum / around[k].count - p;
            const double length = way.norm();
            if (length > 0.0) {
                p = to_single(p + way * std::min(0.1, distance / length));
            }
        }
    }
}

std::vector<std::vector<std::int32_t>> find_holes(const std::vector<mesh::Triangle>& triangles,
                                                  const std::vector<std::uint8_t>& candidate) {
    EdgeSet edges;
    const auto watched = [&](std::int32_t from, std::int32_t to) { return candidate[from] != 0 || candidate[to] != 0; };
    for (const mesh::Triangle& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            if (watched(t[i], t[(i + 1) % 3])) {
                edges.add(t[i], t[(i + 1) % 3]);
            }
        }
    }
    std::vector<std::int32_t> after(candidate.size(), -1);
    std::vector<std::int32_t> starts;
    for (const mesh::Triangle& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::int32_t from = t[i], to = t[(i + 1) % 3];
            if (watched(from, to) && !edges.has(to, from)) {
                after[to] = from;
                starts.push_back(to);
            }
        }
    }
    std::sort(starts.begin(), starts.end());
    std::vector<std::vector<std::int32_t>> holes;
    for (const std::int32_t start : starts) {
        std::vector<std::int32_t> hole;
        for (std::int32_t p = start; after[p] >= 0;) {
            hole.push_back(p);
            const std::int32_t next = after[p];
            after[p] = -1;
            p = next;
        }
        if (!hole.empty()) {
            holes.push_back(std::move(hole));
        }
    }
    return holes;
}

std::vector<std::size_t> drop_opposite_duplicates(std::vector<mesh::Triangle>& triangles,
                                                  std::vector<std::int32_t>& source,
                                                  const std::vector<std::uint8_t>& candidate) {
    std::vector<std::pair<mesh::Triangle, std::size_t>> found;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        mesh::Triangle corners = triangles[k];
        if (std::all_of(corners.begin(), corners.end(), [&](std::int32_t p) { return candidate[p] != 0; })) {
            std::sort(corners.begin(), corners.end());
            found.emplace_back(corners, k);
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<std::size_t> dropped;
    for (std::size_t i = 1; i < found.size(); ++i) {
        if (found[i].first == found[i - 1].first) {
            dropped.insert(dropped.end(), {found[i - 1].second, found[i].second});
        }
    }
    std::sort(dropped.begin(), dropped.end());
    std::size_t kept = 0;
    auto next = dropped.begin();
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (next != dropped.end() && *next == k) {
            ++next;
            continue;
        }
        source[kept] = source[k];
        triangles[kept++] = triangles[k];
    }
    triangles.resize(kept);
    source.resize(kept);
    return dropped;
}

}  // namespace mq::layered_depth
