// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

using mesh::Triangle;

/// Where a triangle comes from: the operand, and its index there.
struct Source {
    std::int32_t operand = -1;
    std::int32_t triangle = -1;
    std::int32_t moved_from = -1;  ///< the triangle of which it was made, even if its corners were moved since
};

/// The triangles of all operands in one list. Operands are closed and oriented; they may cross themselves.
struct Soup {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    std::vector<Source> source;  ///< origin of each triangle; triangle -1 where corners are not those of the operand's
    std::vector<char> moved;  ///< for each vertex whether it was moved from the operand's place; empty: none is moved
    /// For each vertex whether several vertices of one operand were merged into it, as where sheets touch; empty: none.
    std::vector<char> shared;
    int operands = 0;
};

/// A triangle that coincides with another one on the same vertices, oriented the same way (+1) or oppositely (-1).
struct CoincidentTriangle {
    std::int32_t triangle = -1;
    std::int32_t of = -1;
    int turn = 1;
};

/// Sets the source triangle of triangles with moved vertices to -1.
void forget_moved_triangles(Soup& soup);

/// The box of each operand's triangles.
std::vector<Box> operand_boxes(const Soup& soup);

/// Gives vertices in the same place the same index (the lowest), wherever boxes of operands meet.
/// @param boxes  that contain the operands
void merge_vertices(Soup& soup, const std::vector<Box>& boxes);

/// Gives all vertices in the same place the lowest of their indices.
void merge_all_vertices(Soup& soup);

/// Gives vertices of these pairs of triangles that are in the same place the lowest of their indices.
void merge_touching(Soup& soup, const std::vector<std::array<std::int32_t, 2>>& pairs);

/// Triangles with the same three vertices, whatever their order: all but the first of each set.
std::vector<CoincidentTriangle> find_twins(const Soup& soup);
/// Likewise, but searches only the triangles `among`.
std::vector<CoincidentTriangle> find_twins(const Soup& soup, const std::vector<std::int32_t>& among);

}  // namespace mq::boolean
