// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "mesh/triangle_mesh.h"
#include "wrap/lattice/input_surface.h"

namespace mq::wrap {

/// Bounds for the distances between a wrap and its input, mm: for all points of both, and at most a fiftieth of a
/// spacing above the largest distance. A fiftieth of a spacing where nothing is farther.
struct WrapDistance {
    /// Largest distance of the wrap from the input, without the triangles that close gaps.
    double to_input = 0.0;
    Vec3 to_input_where = Vec3::Zero();
    /// Largest distance from the wrap of points of the input that are outside of it. Points inside may be at any depth.
    double from_input = 0.0;
    Vec3 from_input_where = Vec3::Zero();
};

/// @param source  of each triangle of the wrap; -1: it closes a gap
/// @throws Cancelled
WrapDistance wrap_distance(const mesh::TriangleMesh& wrap, const std::vector<std::int32_t>& source,
                           const InputSurface& input, double spacing, Progress& progress);

}  // namespace mq::wrap
