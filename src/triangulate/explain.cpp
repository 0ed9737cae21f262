// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/explain.h"

#include <cmath>
#include <cstdio>

#include "base/angle.h"
#include "triangulate/corner_angle.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

std::string entity_name(const Workspace& work, int vertex) {
    const mesh::VertexEntity& e = work.mesh.vertex(vertex).entity;
    return work.session.topology().name_of({e[0], e[1]});
}

std::string edge_name(const Workspace& work, int segment) {
    return work.session.topology().name_of({1, work.mesh.segment(segment).edge});
}

std::string degrees(double radians) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f degrees", radians / kDegree);
    return text;
}

std::string narrow_corner(const Workspace& work, int triangle) {
    const SmallestAngle smallest = smallest_angle(work.mesh, triangle);
    const int a = work.mesh.segment_of(smallest.half_edge);
    const int b = work.mesh.segment_of(SurfaceMesh::prev(smallest.half_edge));
    return "corner of " + degrees(smallest.angle) + " between " + edge_name(work, a) + " and " + edge_name(work, b) +
           " at " + entity_name(work, work.mesh.vertex_of(smallest.half_edge));
}

}  // namespace

std::string explain(const Workspace& work, int triangle, const Exemption& exemption) {
    const std::string where = " on " + work.session.topology().name_of({2, work.mesh.face_of(triangle)});
    const std::string at_edge = exemption.segment >= 0 ? " at " + edge_name(work, exemption.segment) : "";
    switch (exemption.cause) {
        case Cause::NarrowCorner:
            return narrow_corner(work, triangle) + where;
        case Cause::Apex:
            return "the surface comes to a point at " + entity_name(work, exemption.vertex) +
                   " with too little angle around it" + where;
        case Cause::NarrowCluster:
            return "edges near the narrow corner at " + entity_name(work, exemption.vertex) +
                   " would shrink without end" + at_edge + where;
        case Cause::Resolution:
            return "a further vertex would lie closer than single precision tells apart" + at_edge + where;
        case Cause::MinEdge:
            return "a further vertex would make an edge shorter than min_edge" + at_edge + where;
        case Cause::Crowded:
            return "a further vertex would lie closer to its neighbours than they do to each other" + at_edge + where;
        case Cause::Fold:
            return "a further vertex would fold the mesh" + at_edge + where;
        case Cause::NoSurfacePoint:
            return "the engine finds no point of the surface there" + where;
        case Cause::Stuck:
            return "no change of the triangles around makes the angle larger within the bounds" + where;
        case Cause::Budget:
            return "max_triangles is reached" + where;
    }
    return "unknown" + where;
}

}  // namespace mq::triangulate
