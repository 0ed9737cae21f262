// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// The twin of a corner whose edge has no other triangle.
constexpr std::int32_t kBorder = -1;
/// The twin of a corner whose edge has three or more triangles, or two that run along it the same way.
constexpr std::int32_t kIrregular = -2;

/// For each corner 3 * triangle + i, the directed edge from the triangle's vertex i to its vertex i + 1, the corner of
/// the opposite directed edge, where the undirected edge has just these two; else kBorder or kIrregular.
///
/// A triangle that names a vertex twice has kIrregular corners and is no neighbour of any. O(n), 60 to
/// 140 ns a triangle. Every vertex index must be in range.
std::vector<std::int32_t> edge_twins(const std::vector<Triangle>& triangles, std::size_t vertex_count);

/// The next and the previous corner, or half-edge, of the same triangle.
template <typename Index>
constexpr Index next_corner(Index h) {
    return h % 3 == 2 ? h - 2 : h + 1;
}
template <typename Index>
constexpr Index previous_corner(Index h) {
    return h % 3 == 0 ? h + 2 : h - 1;
}

/// The *fan* of each corner: corners at one vertex have the same fan when a walk over twins leads from one to the
/// other. VertexFans are numbered in the order of their first corners; where every corner has a twin, a vertex is
/// manifold when all of its corners belong to one fan. O(n).
struct VertexFans {
    std::vector<std::int32_t> fan_of;     ///< fan of each corner
    std::vector<std::int32_t> vertex_of;  ///< vertex of each fan
};
VertexFans fans(const std::vector<Triangle>& triangles, const std::vector<std::int32_t>& twins);

/// The component of each triangle, connected over twins; numbered in the order of their first triangles. O(n).
struct Components {
    std::vector<std::int32_t> component_of;
    std::int32_t count = 0;
};
Components components(const std::vector<std::int32_t>& twins);

}  // namespace mq::mesh
