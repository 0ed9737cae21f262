// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/explain.h"

#include <cmath>
#include <cstdio>

#include "triangulate/corner_angle.h"
#include "triangulate/fold.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

std::string entity_name(const mesh::VertexEntity& e) {
    return geometry::name_of({e[0], e[1]});
}

std::string edge_name(const Workspace& work, int segment) {
    return geometry::name_of({1, work.mesh.segment(segment).edge});
}

std::string degrees(double radians) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f degrees", radians * 180.0 / M_PI);
    return text;
}

std::string narrow_corner(const Workspace& work, int triangle) {
    const SmallestAngle smallest = smallest_angle(work.mesh, triangle);
    const int a = work.mesh.segment_of(smallest.half_edge);
    const int b = work.mesh.segment_of(SurfaceMesh::prev(smallest.half_edge));
    return "corner of " + degrees(smallest.angle) + " between " + edge_name(work, a) + " and " + edge_name(work, b) +
           " at " + entity_name(work.mesh.vertex(work.mesh.vertex_of(smallest.half_edge)).entity);
}

}  // namespace

std::string explain(const Workspace& work, int triangle, const Exemption& exemption) {
    const std::string where = " on " + geometry::name_of({2, work.mesh.face_of(triangle)});
    const std::string at_edge = exemption.segment >= 0 ? " at " + edge_name(work, exemption.segment) : "";
    char dbg[600]; int n=0; for(int h=3*triangle;h<3*triangle+3;++h){ int g=work.mesh.twin(h); n+=snprintf(dbg+n,sizeof dbg-n,"| len %.3g ang %.1f seg %d oppal %.2f ent %d ", (work.mesh.point_of(h)-work.mesh.point_of(SurfaceMesh::next(h))).norm(), angle_at(work.mesh,h)*57.3, work.mesh.segment_of(h), g<0?9.0:alignment(work.mesh,g/3), work.mesh.vertex(work.mesh.vertex_of(h)).entity[0]);} fprintf(stderr,"DBG cause %d own %.2f %s face %d at %.5g %.5g %.5g\n",(int)exemption.cause,alignment(work.mesh,triangle),dbg,work.mesh.face_of(triangle)+1,work.mesh.point_of(3*triangle).x(),work.mesh.point_of(3*triangle).y(),work.mesh.point_of(3*triangle).z());
    switch (exemption.cause) {
        case Cause::NarrowCorner:
            return narrow_corner(work, triangle) + where;
        case Cause::NarrowCluster:
            return "edges near the narrow corner at " + entity_name(work.mesh.vertex(exemption.vertex).entity) +
                   " would shrink for ever" + at_edge + where;
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
        case Cause::Budget:
            return "max_triangles is reached" + where;
    }
    return "unknown" + where;
}

}  // namespace mq::triangulate
