// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"
#include "triangulate/work_mesh/workspace.h"

/// Adds closest-point queries for edges and triangles that are not in the mesh yet, to measure their distance from the
/// CAD model before they are inserted.
namespace mq::triangulate {

/// Fraction of the tolerance that new pieces must keep: between the measured points the distance may be slightly
/// larger.
MESHQUALITY_TUNED(double, kNear, 0.94);

/// Adds the query for the point of an edge on a face at a fraction of its length from a to b.
void add_edge_probe(const Workspace& work, int face, const ClassifiedMesh::VertexUse& a,
                    const ClassifiedMesh::VertexUse& b, double at, geometry::Engine::Batch& batch);
/// Adds queries at the middle of an edge, and where it is expected to be farthest (see edge_peak).
void add_edge_probes(const Workspace& work, int face, const ClassifiedMesh::VertexUse& a,
                     const ClassifiedMesh::VertexUse& b, geometry::Engine::Batch& batch);
/// Adds the query where the triangle is expected to be farthest (see expected_peak).
void add_triangle_probe(const Workspace& work, int face, const ClassifiedMesh::VertexUse& a,
                        const ClassifiedMesh::VertexUse& b, const ClassifiedMesh::VertexUse& c,
                        geometry::Engine::Batch& batch);

/// A vertex on a CAD edge.
struct PointOfEdge {
    Vec3 point;
    double t;
};
/// Adds queries around the middle of a segment from a to b; the parameter of a is the smaller one.
void add_segment_probes(const Workspace& work, int edge, const PointOfEdge& a, const PointOfEdge& b,
                        geometry::Engine::Batch& batch);

/// Returns the largest distance in mm; a query without an answer counts as `where_none`.
double largest_distance(const geometry::Engine::Answers& answers, double where_none);

}  // namespace mq::triangulate
