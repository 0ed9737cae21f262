// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"

namespace mq::mesh {

/// A coarse mesh that looks like a fine one from afar.
struct Clusters {
    std::vector<float> corners;        ///< 9 numbers a triangle
    std::vector<std::int32_t> joined;  ///< by triangle of the fine mesh: the coarse one that stands for it; -1: none
};

/// Joins the corners of triangles cell by cell of a grid (Rossignac, Borrel 1993, "Multi-resolution 3D approximations
/// for rendering complex scenes"); what keeps corners in three cells stays a triangle, once. The cells are so large
/// that about `wanted` triangles stay, as the area tells. Time O(n).
/// @param corners 9 numbers for each of `triangles` triangles.
/// @throws Cancelled when `progress` says so.
Clusters cluster(const float* corners, std::size_t triangles, std::size_t wanted, const Progress* progress = nullptr);

}  // namespace mq::mesh
