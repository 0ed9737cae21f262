// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/edges_angle.h"

#include <cmath>

#include "base/angle.h"

namespace mq::triangulate {

namespace {

struct Departure {
    Vec3 way = Vec3::Zero();  // direction in which a segment's edge leaves a vertex; zero if it has none
    double gap = 0.0;         // radians: angle at the chord's far end that the vertex and the end of the curve subtend
};

Departure departure(const Workspace& work, int segment, int vertex) {
    const ClassifiedMesh::Segment& s = work.mesh.segment(segment);
    const int end = s.vertices[0] == vertex ? 0 : 1;
    const geometry::Answer there = work.session.ask(geometry::Query::edge_point(s.edge, s.t[end]));
    if (there.status != geometry::Status::Ok) {
        return {};
    }
    const double forward = s.t[1 - end] > s.t[end] ? 1.0 : -1.0;
    const Vec3& p = work.mesh.vertex(vertex).point;
    const double chord = (work.mesh.vertex(s.vertices[1 - end]).point - p).norm();
    return {forward * there.normal, std::atan2((there.point - work.grid.to_shape(p)).norm(), chord)};
}

}  // namespace

std::optional<EdgesAngle> angle_between_edges(const Workspace& work, int a, int b, int vertex) {
    const Departure first = departure(work, a, vertex);
    const Departure second = departure(work, b, vertex);
    if (!(first.way.squaredNorm() > 0.0) || !(second.way.squaredNorm() > 0.0)) {
        return std::nullopt;
    }
    return EdgesAngle{angle_between(first.way, second.way), first.gap + second.gap};
}

}  // namespace mq::triangulate
