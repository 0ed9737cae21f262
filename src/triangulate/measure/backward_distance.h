// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "triangulate/measure/distance_probes.h"
#include "triangulate/work_mesh/workspace.h"

/// The backward distance (Metro): from the CAD model's sample points (geometry::CadSamples) to pieces of the mesh.
namespace mq::triangulate {

/// A sample point of the CAD model over a triangle of the mesh.
struct CadSampleOverTriangle {
    double distance = 0.0;            ///< distance from the mesh, mm
    Vec3 below = Vec3::Zero();        ///< its projection on the mesh
    int triangle = -1;                ///< the triangle with the projection
    std::array<double, 3> weights{};  ///< barycentric coordinates in that triangle
};
/// Calls `see` for the sample points of the face whose parameters lie in the triangle. A point that is over a
/// neighbouring triangle in space is measured there.
void for_each_cad_sample_over(Workspace& work, int triangle,
                              const std::function<void(const CadSampleOverTriangle&)>& see);

/// Returns the largest distance, in mm, from the triangle of three sites to the sample points with parameters in it
/// that are over it in space. The triangle need not be in the mesh.
double backward_distance(Workspace& work, int face, const ClassifiedMesh::VertexUse& a,
                         const ClassifiedMesh::VertexUse& b, const ClassifiedMesh::VertexUse& c);
/// The point of a curve between two vertices that is farthest from their chord: its distance in mm, and its projection
/// on the chord.
struct BackwardDistance {
    double distance = 0.0;
    Vec3 nearest = Vec3::Zero();
};
BackwardDistance backward_distance(Workspace& work, int edge, const PointOfEdge& a, const PointOfEdge& b);

}  // namespace mq::triangulate
