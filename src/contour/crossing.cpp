// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/crossing.h"

#include <cstddef>
#include <utility>

namespace mq::contour {

namespace {

using Edges = std::array<std::array<std::int8_t, 2>, 4>;

/// The edges between nodes outside and others, in their order around the cell.
CellPolygon edges_around(const std::array<bool, 4>& is_outside) {
    std::array<std::int8_t, 4> outer{};
    std::array<std::int8_t, 4> inner{};
    std::size_t outside = 0;
    std::size_t inside = 0;
    for (std::int8_t k = 0; k < 4; ++k) {
        if (is_outside[static_cast<std::size_t>(k)]) {
            outer[outside++] = k;
        } else {
            inner[inside++] = k;
        }
    }
    switch (outside) {
        case 1:
            return {3, Edges{{{outer[0], inner[0]}, {outer[0], inner[1]}, {outer[0], inner[2]}}}};
        case 2:
            return {4, Edges{{{outer[0], inner[0]}, {outer[0], inner[1]}, {outer[1], inner[1]}, {outer[1], inner[0]}}}};
        case 3:
            return {3, Edges{{{outer[0], inner[0]}, {outer[1], inner[0]}, {outer[2], inner[0]}}}};
        default:
            return {};
    }
}

}  // namespace

CellPolygon cell_polygon(const std::array<Vec3, 4>& corners, const std::array<bool, 4>& is_outside) {
    CellPolygon polygon = edges_around(is_outside);
    if (polygon.count == 0) {
        return polygon;
    }
    const auto corner = [&](std::size_t k, std::size_t end) -> const Vec3& {
        return corners[static_cast<std::size_t>(polygon.edges[k][end])];
    };
    const auto middle = [&](std::size_t k) { return Vec3(corner(k, 0) + corner(k, 1)); };
    const Vec3 normal = (middle(1) - middle(0)).cross(middle(2) - middle(0));
    if (normal.dot(corner(0, 0) - corner(0, 1)) < 0.0) {
        if (polygon.count == 4) {
            std::swap(polygon.edges[1], polygon.edges[2]);
            std::swap(polygon.edges[0], polygon.edges[3]);
        } else {
            std::swap(polygon.edges[0], polygon.edges[2]);
        }
    }
    return polygon;
}

}  // namespace mq::contour
