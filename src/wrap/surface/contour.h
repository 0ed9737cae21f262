// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "wrap/surface/crossings.h"

namespace mq::wrap {

/// The surface between the nodes outside and the others.
struct Contour {
    std::vector<Vec3> points;
    std::vector<mesh::Triangle> triangles;  ///< counter-clockwise seen from outside
    std::vector<std::int32_t> source;       ///< the input's triangle that each one lies on; -1 where it closes a gap
    std::vector<std::int32_t> patch;        ///< the CAD face that each one lies on; -1 where it closes a gap
    /// The crossing whose plane each triangle stands for; -1: its own, where it closes a gap.
    std::vector<std::int32_t> plane;
};

/// The contour of all cells: extended marching cubes (Kobbelt, Botsch, Schwanecke and Seidel 2001) on tetrahedra.
///
/// In a cell where normals meet at an edge a vertex lies where the quadric of their planes has its least value (Garland
/// and Heckbert 1997), and on a face of such a cell where the two lines meet that the planes cut from it. The surface
/// of a cell is the cone from its vertex over the polygon of crossings and points on faces, which goes once around the
/// cell's border. The vertex is inside of the cell, which is convex, so the cone does not cross itself; cells share
/// polygons on their faces, so all of it is closed, 2-manifold and free of self-intersections.
/// @throws Cancelled
Contour contour(const NodeStates& states, const CrossedCells& cells, const Progress& progress);

}  // namespace mq::wrap
