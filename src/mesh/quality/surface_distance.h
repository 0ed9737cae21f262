// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Distances of points of one surface from another surface, mm.
struct SurfaceDistance {
    double mean = 0.0;  ///< weighted by area
    double largest = 0.0;
    Vec3 where = Vec3::Zero();  ///< the sample point with the largest distance
};

/// The distances of the corners and the centres of the triangles of one surface from another one: one direction of the
/// Hausdorff distance, sampled.
/// @throws InvalidInput when one has no triangles and the other one has
/// @throws Cancelled
SurfaceDistance surface_distance(const TriangleMesh& from, const TriangleMesh& to, const Progress& progress);

}  // namespace mq::mesh
