// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boolean/arrangement/soup.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// Origin of a vertex: an operand's own, unchanged.
constexpr char kFromOperand = 0;
/// Origin of a vertex: constructed by the arrangement or moved since, and to be rounded.
constexpr char kConstructed = 1;
/// Origin of a vertex: moved or constructed earlier, and rounded.
constexpr char kRounded = 2;

/// The result while it is extracted and repaired.
struct ResultMesh {
    std::vector<Vec3> vertices;
    std::vector<char> made;  ///< origin of each vertex: kFromOperand, kConstructed or kRounded
    std::vector<Triangle> triangles;
    std::vector<Source> source;  ///< operand's triangle for each triangle; operand -1 where it was made or changed here
    std::vector<std::int32_t> from;  ///< for each triangle the soup's triangle of which it is or was a piece
    std::vector<double>
        displacement;  ///< mm, by triangle: bound for the distance of its points from their exact places
};

/// Adds to the displacement of each triangle the largest displacement of its vertices.
/// @param of_vertices  how far each vertex was moved, mm
void add_displacements(ResultMesh& draft, const std::vector<double>& of_vertices);

/// Removes the triangles that are marked, and vertices that no other triangle uses.
void remove_triangles(ResultMesh& draft, const std::vector<char>& marked);

/// Removes vertices that no triangle uses.
void remove_unused_vertices(ResultMesh& draft);

}  // namespace mq::boolean
