// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Sample points at which the deviation of a mesh is measured.
struct DeviationSamples {
    /// All used vertices, the middles of all edges, and the centroids of all triangles, in the model's frame; then at
    /// most 4,000 more inside of triangles that have a large fraction of the area.
    std::vector<Vec3> points;
    /// The points of each triangle: corners, edge middles, centroid.
    std::vector<std::array<std::uint32_t, 7>> of_triangle;
    /// The triangles to which the last points belong.
    std::vector<std::uint32_t> inside_of;

    /// The largest value on each triangle, given the values at the points.
    std::vector<double> largest(const std::vector<double>& at_points) const;
};

/// The mesh must be valid (see measure).
DeviationSamples deviation_samples(const TriangleMesh& mesh);

}  // namespace mq::mesh
