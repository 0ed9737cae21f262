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
    bool is_sharp = false;     ///< whether the normals of the crossings meet at an edge
    Vec3 apex = Vec3::Zero();  ///< the vertex in the cell, or the crossing from which the fan starts
    int first = 0;             ///< that crossing, by its index in the polygon
    /// Between each crossing and the next one: whether the face that has both has a vertex, and where.
    std::array<bool, 4> has_face_point{};
    std::array<Vec3, 4> face_points{};
};

/// The surface of a cell: extended marching cubes (Kobbelt, Botsch, Schwanecke and Seidel 2001) on a tetrahedron.
///
/// The vertex of a cell in which normals meet at an edge (they turn more than on a ball of the level set's least
/// radius) lies at the least value of the quadric of their planes (Garland and Heckbert 1997). The vertex on a face of
/// such a cell lies where the two lines meet that the planes cut from the face. If only patches meet in the cell, both
/// vertices lie on the border between these; in all other cells they lie in the middle. The surface is the cone from
/// the vertex over the polygon of crossings and points on faces, which goes once around the cell's border. The vertex
/// is inside of the cell, which is convex, so the cone does not cross itself.
/// @param level_set  the level set whose zero set the vertices are moved to, and whose patches have borders; may be
/// null
CellSurface cell_surface(const CrossedCell& cell, const std::vector<Crossing>& crossings, const LevelSet* level_set);

/// The corners of the face of a cell on which the crossings k and k + 1 of its polygon lie, ascending.
std::array<std::size_t, 3> face_between(const CellPolygon& polygon, int k);

}  // namespace mq::contour
