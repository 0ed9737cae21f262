// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/edges_angle.h"

#include "base/angle.h"

namespace mq::triangulate {

namespace {

// Returns the direction in which a segment's edge leaves a vertex; zero if it has none.
Vec3 way_from(const Workspace& work, int segment, int vertex) {
    const ClassifiedMesh::Segment& s = work.mesh.segment(segment);
    const int end = s.vertices[0] == vertex ? 0 : 1;
    const geometry::Answer there = work.session.ask(geometry::Query::edge_point(s.edge, s.t[end]));
    const double forward = s.t[1 - end] > s.t[end] ? 1.0 : -1.0;
    return there.status == geometry::Status::Ok ? Vec3(forward * there.normal) : Vec3::Zero();
}

}  // namespace

std::optional<double> angle_between_edges(const Workspace& work, int a, int b, int vertex) {
    const Vec3 along_a = way_from(work, a, vertex);
    const Vec3 along_b = way_from(work, b, vertex);
    const bool found = along_a.squaredNorm() > 0.0 && along_b.squaredNorm() > 0.0;
    return found ? std::optional(angle_between(along_a, along_b)) : std::nullopt;
}

}  // namespace mq::triangulate
