// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/workspace.h"

/// Where pieces of the mesh that need not be there are measured, before they are put in: questions how far they are
/// from the part.
namespace mq::triangulate {

/// Of the tolerance: between the places that are measured the mesh may be a little farther.
constexpr double kNear = 0.94;

/// At one place of an edge on a face, a part of the way from a to b.
void add_edge_probe(const Workspace& work, int face, const mesh::SurfaceMesh::Site& a, const mesh::SurfaceMesh::Site& b,
                    double at, geometry::Engine::Batch& batch);
/// At its middle, and where else it is expected to be farthest (see edge_peak).
void add_edge_probes(const Workspace& work, int face, const mesh::SurfaceMesh::Site& a,
                     const mesh::SurfaceMesh::Site& b, geometry::Engine::Batch& batch);
/// Where the triangle is expected to be farthest (see expected_peak).
void add_triangle_probe(const Workspace& work, int face, const mesh::SurfaceMesh::Site& a,
                        const mesh::SurfaceMesh::Site& b, const mesh::SurfaceMesh::Site& c,
                        geometry::Engine::Batch& batch);

/// A vertex on a CAD edge.
struct PointOfEdge {
    Vec3 point;
    double t;
};
/// Around the middle of a segment from a to b, t of a below that of b.
void add_segment_probes(const Workspace& work, int edge, const PointOfEdge& a, const PointOfEdge& b,
                        geometry::Engine::Batch& batch);

/// mm; `where_none` counts where the engine finds no point.
double largest_distance(const geometry::Engine::Answers& answers, double where_none);

}  // namespace mq::triangulate
