// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/retained_surface.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace mq::layered_depth {

namespace {

/// Marks the points of retained triangles that removed triangles, or triangles that are reversed differently, have as
/// well.
std::vector<std::uint8_t> mixed_points(const OperandSet& pair, const std::vector<Retention>& fate) {
    std::vector<std::uint8_t> seen(pair.points.size(), 0);
    for (std::size_t t = 0; t < fate.size(); ++t) {
        for (const std::int32_t p : pair.triangles[t]) {
            seen[p] |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(fate[t]));
        }
    }
    for (std::uint8_t& bits : seen) {
        bits = (bits & (bits - 1)) != 0 ? 1 : 0;
    }
    return seen;
}

/// Finds the edges that only one retained triangle has.
void find_border(RetainedSurface& surface) {
    std::vector<RetainedSurface::BorderEdge> edges;
    for (std::size_t k = 0; k < surface.triangles.size(); ++k) {
        const mesh::Triangle& t = surface.triangles[k];
        for (int i = 0; i < 3; ++i) {
            const std::int32_t from = t[i], to = t[(i + 1) % 3];
            if (surface.on_border[from] != 0 && surface.on_border[to] != 0) {
                edges.push_back({from, to, static_cast<std::int32_t>(k)});
            }
        }
    }
    using Edge = RetainedSurface::BorderEdge;
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        const auto [a_low, a_high] = std::minmax(a.from, a.to);
        const auto [b_low, b_high] = std::minmax(b.from, b.to);
        return std::tie(a_low, a_high, a.triangle) < std::tie(b_low, b_high, b.triangle);
    });
    const auto same = [](const Edge& a, const Edge& b) {
        return std::minmax(a.from, a.to) == std::minmax(b.from, b.to);
    };
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t j = i + 1;
        while (j < edges.size() && same(edges[i], edges[j])) {
            ++j;
        }
        if (j == i + 1) {
            surface.border.push_back(edges[i]);
        }
        i = j;
    }
}

}  // namespace

RetainedSurface retained_surface(const OperandSet& pair, const std::vector<Retention>& fate) {
    RetainedSurface surface;
    surface.points = pair.points;
    for (std::size_t t = 0; t < fate.size(); ++t) {
        if (fate[t] == Retention::Removed) {
            continue;
        }
        mesh::Triangle triangle = pair.triangles[t];
        if (fate[t] == Retention::KeptReversed) {
            std::swap(triangle[1], triangle[2]);
        }
        surface.triangles.push_back(triangle);
        surface.source.push_back(static_cast<std::int32_t>(t));
    }
    surface.lies_on = surface.source;
    surface.on_border = mixed_points(pair, fate);
    find_border(surface);
    std::fill(surface.on_border.begin(), surface.on_border.end(), std::uint8_t{0});
    for (const RetainedSurface::BorderEdge& edge : surface.border) {
        surface.on_border[edge.from] = surface.on_border[edge.to] = 1;
    }
    return surface;
}

}  // namespace mq::layered_depth
