// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "contour/crossing.h"
#include "contour/level_set.h"
#include "mesh/triangle_mesh.h"

namespace mq::contour {

/// A surface between nodes outside and others.
struct Contour {
    std::vector<Vec3> points;               ///< single-precision numbers
    std::vector<mesh::Triangle> triangles;  ///< counter-clockwise seen from outside
    std::vector<std::int32_t> source;       ///< the input's triangle to which each one belongs; -1: it closes a gap
    std::vector<std::int32_t> patch;        ///< those of the crossings, until others are given
    /// The crossing whose plane each triangle stands for; -1: its own, where it closes a gap, and where a level set has
    /// no edge: there it is nearer to it than the planes at its corners are.
    std::vector<std::int32_t> plane;
};

/// The contour of all cells (cell_surface). Cells share points on their faces, so all of it is closed, 2-manifold and
/// free of self-intersections, before its points are rounded to single precision.
/// @param level_set  as of cell_surface
/// @throws Cancelled
Contour contour(const CrossedCells& cells, const LevelSet* level_set, const Progress& progress);

}  // namespace mq::contour
