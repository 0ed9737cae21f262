// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "triangulate/distance_probes.h"
#include "triangulate/workspace.h"

/// Distances of the part's points (SpanPoints) from pieces of the mesh.
namespace mq::triangulate {

/// A point of the part over a triangle of the mesh.
struct PointOver {
    double distance = 0.0;            ///< from the mesh, mm
    Vec3 below = Vec3::Zero();        ///< on the mesh
    int triangle = -1;                ///< that this is on
    std::array<double, 3> weights{};  ///< barycentric, of that triangle
};
/// Calls `see` for the points of the face whose parameters lie in the triangle. Those that are not over it, but over
/// one beside it, are measured there.
void each_point_over(Workspace& work, int triangle, const std::function<void(const PointOver&)>& see);

/// The farthest of the points with parameters in the triangle of three sites of a face that are over it, mm. It need
/// not be there.
double way_back(Workspace& work, int face, const mesh::SurfaceMesh::Site& a, const mesh::SurfaceMesh::Site& b,
                const mesh::SurfaceMesh::Site& c);
/// The farthest point of a curve between two vertices on it from the straight line between them, mm, and where that is
/// nearest.
struct WayBack {
    double distance = 0.0;
    Vec3 nearest = Vec3::Zero();
};
WayBack way_back(Workspace& work, int edge, const PointOfEdge& a, const PointOfEdge& b);

}  // namespace mq::triangulate
