// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"

namespace mq::mesh {

/// A coarse mesh for the display in place of a fine one.
struct ClusteredMesh {
    std::vector<float> corners;  ///< 9 numbers for each triangle
    /// For each triangle of the fine mesh the coarse one that represents it; -1: none.
    std::vector<std::int32_t> joined;
};

/// Joins the corners of triangles cell by cell of a grid (Rossignac, Borrel 1993, "Multi-resolution 3D approximations
/// for rendering complex scenes"); triangles with corners in three cells stay, each once. The size of the cells is
/// computed from the area so that about `wanted` triangles stay; a triangle with a number that is not finite is left
/// out. Time O(n).
/// @param corners 9 numbers for each of `triangles` triangles.
/// @throws Cancelled when `progress` says so.
ClusteredMesh cluster(const float* corners, std::size_t triangles, std::size_t wanted,
                      const Progress* progress = nullptr);

}  // namespace mq::mesh
