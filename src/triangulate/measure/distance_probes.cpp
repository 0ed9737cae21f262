// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/distance_probes.h"

#include <algorithm>

#include "triangulate/measure/deviation_peaks.h"

namespace mq::triangulate {

namespace {

using geometry::Query;
using VertexUse = ClassifiedMesh::VertexUse;

void add_on_face(const Workspace& work, int face, const Vec3& p, const Vec2& uv, geometry::Engine::Batch& batch) {
    batch.push_back(Query::face_nearest(face, work.grid.to_shape(p), uv.x(), uv.y()));
}

}  // namespace

void add_edge_probe(const Workspace& work, int face, const VertexUse& a, const VertexUse& b, double at,
                    geometry::Engine::Batch& batch) {
    add_on_face(work, face, (1.0 - at) * a.point + at * b.point, (1.0 - at) * a.uv + at * b.uv, batch);
}

void add_edge_probes(const Workspace& work, int face, const VertexUse& a, const VertexUse& b,
                     geometry::Engine::Batch& batch) {
    constexpr double kMiddle = 0.5;  // Fraction of an edge's length.
    add_edge_probe(work, face, a, b, kMiddle, batch);
    if (const double at = edge_peak(a, b).at; at != kMiddle) {
        add_edge_probe(work, face, a, b, at, batch);
    }
}

void add_triangle_probe(const Workspace& work, int face, const VertexUse& a, const VertexUse& b, const VertexUse& c,
                        geometry::Engine::Batch& batch) {
    const auto w = expected_peak(a, b, c).weights;
    add_on_face(work, face, w[0] * a.point + w[1] * b.point + w[2] * c.point, w[0] * a.uv + w[1] * b.uv + w[2] * c.uv,
                batch);
}

void add_segment_probes(const Workspace& work, int edge, const PointOfEdge& a, const PointOfEdge& b,
                        geometry::Engine::Batch& batch) {
    for (const double at : {0.35, 0.5, 0.65}) {
        batch.push_back(Query::edge_nearest(edge, work.grid.to_shape((1.0 - at) * a.point + at * b.point),
                                            (1.0 - at) * a.t + at * b.t, a.t, b.t));
    }
}

double largest_distance(const geometry::Engine::Answers& answers, double where_none) {
    double largest = 0.0;
    for (const geometry::Answer& answer : answers) {
        largest = std::max(largest, answer.found() ? answer.distance : where_none);
    }
    return largest;
}

}  // namespace mq::triangulate
