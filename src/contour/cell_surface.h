// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contour/crossing.h"
#include "contour/level_set.h"

namespace mq::contour {

/// The surface within one cell: a fan from one of the crossings, or a cone from a vertex in it.
struct CellSurface {
    bool is_cone = false;
    bool is_sharp = false;     ///< whether normals meet at an edge
    Vec3 apex = Vec3::Zero();  ///< the vertex in the cell, or the crossing from which the fan goes
    int first = 0;             ///< that crossing, by its place in the polygon
    /// Between a crossing and the next one: whether there is a vertex on the face with both, and where.
    std::array<bool, 4> has_face_point{};
    std::array<Vec3, 4> face_points{};
};

/// The surface of a cell: extended marching cubes (Kobbelt, Botsch, Schwanecke and Seidel 2001) on a tetrahedron.
///
/// Where normals meet at an edge (they turn more than on a ball of the level set's least radius) the vertex lies where
/// the quadric of their planes has its least value (Garland and Heckbert 1997), and on a face of such a cell where the
/// two lines meet that the planes cut from it. Where only patches meet they lie on the border, and elsewhere in the
/// middle. The surface is the cone from the vertex over the polygon of crossings and points on faces, which goes once
/// around the cell's border. The vertex is inside of the cell, which is convex, so the cone does not cross itself.
/// @param level_set  on whose zero set vertices are moved, which finds the borders of patches; null: there is none
CellSurface cell_surface(const CrossedCell& cell, const std::vector<Crossing>& crossings, const LevelSet* level_set);

/// The corners of the face of a cell on which the crossings k and k + 1 of its polygon lie, ascending.
std::array<std::size_t, 3> face_between(const CellPolygon& polygon, int k);

}  // namespace mq::contour
