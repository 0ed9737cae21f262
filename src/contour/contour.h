// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "contour/crossing.h"
#include "contour/level_set.h"
#include "mesh/triangle_mesh.h"

namespace mq::contour {

/// A triangulated surface between the lattice nodes outside and all others.
struct Contour {
    std::vector<Vec3> points;               ///< single-precision numbers
    std::vector<mesh::Triangle> triangles;  ///< counter-clockwise seen from outside
    std::vector<std::int32_t> source;  ///< by triangle: the input's triangle that it belongs to; -1: it closes a gap
    std::vector<std::int32_t> patch;   ///< by triangle: the patch of its crossing, unless it is replaced later
    /// By triangle: the crossing whose plane it represents; -1: its own plane, if it closes a gap or the level set has
    /// no edge there: the triangle is then nearer to the level set than the planes at its corners.
    std::vector<std::int32_t> plane;
    /// By triangle: points of CollapseLimits::kept_points that it is near; empty: none are kept.
    std::vector<std::vector<std::int32_t>> kept;
};

/// Removes the triangles without vertices (-1), and the points that no triangle has. The others keep their order.
void remove_gone(Contour& surface);

/// The contour of all cells (cell_surface). Cells share points on their faces, so all of it is closed, 2-manifold and
/// free of self-intersections, before its points are rounded to single precision.
/// @param level_set  as in cell_surface()
/// @throws Cancelled
Contour contour(const CrossedCells& cells, const LevelSet* level_set, const Progress& progress);

}  // namespace mq::contour
