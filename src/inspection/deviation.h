// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "geometry/session.h"
#include "inspection/alignment.h"
#include "inspection/mesh_distance.h"
#include "mesh/triangle_mesh.h"

namespace mq::inspection {

struct DeviationOptions {
    Align align = Align::None;
    std::vector<PointPair> pairs;  ///< for Align::Pairs at least three, for Align::ThreeTwoOne six
    std::vector<Vec3> fit_points;  ///< the points that are aligned; empty: those that are measured
};

/// Signed distances of points from a reference, by point, and the motion by which they were aligned before.
struct Deviation {
    std::vector<SignedDistance> distances;
    Alignment alignment;
    std::size_t by_mesh = 0;  ///< points with the distance from the mesh, as no projection was as near
};

/// Measures points against a mesh, or the CAD that it was made of.
/// @param reference  the mesh, in the frame of the points, with origin zero
/// @param session    of the CAD; null: distances are from the mesh
/// @param deviation  mm: largest distance of mesh and CAD, both ways
/// @returns no distances where the alignment has not converged
/// @throws InvalidInput where there are no triangles or no points; Cancelled
Deviation measure_deviation(const std::vector<Vec3>& points, const mesh::TriangleMesh& reference,
                            geometry::Session* session, double deviation, const DeviationOptions& options,
                            Progress& progress);

}  // namespace mq::inspection
