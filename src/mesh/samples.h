// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Where the distance of a mesh from something is measured.
struct DeviationSamples {
    /// All used vertices, the middles of all edges, and the centroids of all triangles, in the part's frame; then at
    /// most 4,000 more inside of triangles that are large parts of the mesh.
    std::vector<Vec3> points;
    /// The points of each triangle: corners, edge middles, centroid.
    std::vector<std::array<std::uint32_t, 7>> of_triangle;
    /// The triangles of the last points.
    std::vector<std::uint32_t> inside_of;

    /// The largest value of each triangle, of values at the points.
    std::vector<double> largest(const std::vector<double>& at_points) const;
};

/// The mesh must be valid (see measure).
DeviationSamples deviation_samples(const TriangleMesh& mesh);

}  // namespace mq::mesh
