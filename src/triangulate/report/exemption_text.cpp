// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/exemption_text.h"

#include <cmath>
#include <cstdio>

#include "base/angle.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/edges_angle.h"

namespace mq::triangulate {

namespace {

std::string entity_name(const Workspace& work, int vertex) {
    const mesh::VertexEntity& e = work.mesh.vertex(vertex).entity;
    return work.session.topology().name_of({e[0], e[1]});
}

std::string edge_name(const Workspace& work, int edge) {
    return work.session.topology().name_of({1, edge});
}

std::string degrees(double radians) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f°", radians / kDegree);
    return text;
}

std::string narrow_corner(const Workspace& work, int triangle) {
    const SmallestAngle smallest = smallest_angle(work.mesh, triangle);
    const int a = work.mesh.segment(work.mesh.segment_of(smallest.half_edge)).edge;
    const int b = work.mesh.segment(work.mesh.segment_of(ClassifiedMesh::prev(smallest.half_edge))).edge;
    return "the shape itself has a corner of " + degrees(smallest.angle) + " between " + edge_name(work, a) + " and " +
           edge_name(work, b) + " at " + entity_name(work, work.mesh.vertex_of(smallest.half_edge));
}

// Whether the triangle fills a corner that the edges themselves enclose, not only their chords. Local improvement can
// lead to this.
bool fills_corner(const Workspace& work, int triangle) {
    const SmallestAngle smallest = smallest_angle(work.mesh, triangle);
    const int vertex = work.mesh.vertex_of(smallest.half_edge);
    const int a = work.mesh.segment_of(smallest.half_edge);
    const int b = work.mesh.segment_of(ClassifiedMesh::prev(smallest.half_edge));
    if (a < 0 || b < 0 || work.mesh.vertex(vertex).entity[0] != 0) {
        return false;
    }
    const auto enclosed = angle_between_edges(work, a, b, vertex);
    return enclosed && *enclosed < kNarrowed * smallest.angle;
}

std::string narrow_cluster(const Workspace& work, InfeasibleCorner& forces, int vertex, const std::string& at_edge) {
    const std::string node = entity_name(work, vertex);
    if (const auto angle = forces.at(vertex)) {
        return "edges of the shape that meet at " + degrees(*angle) + " leave no room for larger angles at " + node;
    }
    return "edges at the narrow corner of the shape would become ever shorter at " + node + at_edge;
}

// Whether three triangles around the vertex cannot all reach the bound, since the total angle is too small.
bool too_little_around(const ClassifiedMesh& mesh, int half_edge, double bound) {
    const auto fan = apex_fan(mesh, half_edge);
    return fan && fan->closed && fan->sum < 3.0 * bound;
}

std::string point_of_surface(const Workspace& work, int vertex) {
    return "the surface comes to a point with too little angle around it at " + entity_name(work, vertex);
}

// Explains the triangle by its present shape, independent of what prevented the improvement of earlier ones.
std::string explain_final(const Workspace& work, int triangle, double bound) {
    if (fills_corner(work, triangle)) {
        return narrow_corner(work, triangle);
    }
    const int corner = smallest_angle(work.mesh, triangle).half_edge;
    return too_little_around(work.mesh, corner, bound) ? point_of_surface(work, work.mesh.vertex_of(corner)) : "";
}

}  // namespace

std::string explain(const Workspace& work, InfeasibleCorner& forces, int triangle, const Exemption& exemption,
                    double bound) {
    const std::string where = " on " + work.session.topology().name_of({2, work.mesh.face_of(triangle)});
    if (exemption.cause == Cause::Budget) {
        // Takes precedence over all other causes, since the triangle was not tried.
        return "the triangle limit max_triangles was reached" + where;
    }
    const std::string at_edge = exemption.edge >= 0 ? " at " + edge_name(work, exemption.edge) : "";
    if (const std::string now = explain_final(work, triangle, bound); !now.empty()) {
        return now + where;
    }
    switch (exemption.cause) {
        case Cause::NarrowCorner:
            return narrow_corner(work, triangle) + where;
        case Cause::Apex:
            return point_of_surface(work, exemption.vertex) + where;
        case Cause::NarrowCluster:
            return narrow_cluster(work, forces, exemption.vertex, at_edge) + where;
        case Cause::Resolution:
            return "points cannot be placed any closer in single precision" + at_edge + where;
        case Cause::FaceFloorRaised:
            return "too many triangles there have no room for a further point, so the face is refined no further" +
                   at_edge + where;
        case Cause::MinEdge:
            return "a further point would make an edge shorter than min_edge" + at_edge + where;
        case Cause::Crowded:
            return "a further point would lie closer to its neighbours than they do to each other" + at_edge + where;
        case Cause::Fold:
            return "a further point would fold the mesh" + at_edge + where;
        case Cause::NoSurfacePoint:
            return "no point of the surface was found there" + where;
        case Cause::NoImprovingChange:
            return "no change of the triangles around it makes the angle larger within the limits" + where;
        case Cause::Budget:
            break;
    }
    return "unknown" + where;
}

}  // namespace mq::triangulate
