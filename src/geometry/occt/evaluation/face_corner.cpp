// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/face_corner.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angle.h"
#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {

namespace {

/// An end of an edge at the vertex.
struct EdgeEnd {
    TopoDS_Edge edge;
    bool first;    ///< whether its parameters begin at the vertex
    Vec3 way;      ///< into the edge
    Vec3 normal;   ///< Su x Sv of the face; zero where it has none
    bool leaves;   ///< whether the border of the face, with the face on its left, begins with the edge at the vertex
    bool arrives;  ///< whether the border ends with the edge at the vertex; both hold for an edge inside of the face
};

Vec3 way_into(const TopoDS_Edge& edge, const TopoDS_Face& face, bool first) {
    double t0 = 0.0;
    double t1 = 0.0;
    BRep_Tool::Range(edge, t0, t1);
    TopLoc_Location location;
    double ignored = 0.0;
    const bool in_space = !BRep_Tool::Curve(edge, location, ignored, ignored).IsNull();
    const BRepAdaptor_Curve curve = in_space ? BRepAdaptor_Curve(edge) : BRepAdaptor_Curve(edge, face);
    gp_Pnt point;
    gp_Vec along;
    curve.D1(first ? t0 : t1, point, along);
    const Vec3 way = first ? to_vec(along) : Vec3(-to_vec(along));
    if (way.squaredNorm() > 0.0) {
        return way;
    }
    constexpr double kStep = 1e-3;  // fraction of the range, for curves without a derivative at the end
    return to_vec(curve.Value(first ? t0 + kStep * (t1 - t0) : t1 - kStep * (t1 - t0))) - to_vec(point);
}

Vec3 normal_at(const TopoDS_Edge& edge, const TopoDS_Face& face, bool first) {
    double t0 = 0.0;
    double t1 = 0.0;
    const Handle(Geom2d_Curve) on_face = BRep_Tool::CurveOnSurface(edge, face, t0, t1);
    if (on_face.IsNull()) {
        return Vec3::Zero();
    }
    const gp_Pnt2d uv = on_face->Value(first ? t0 : t1);
    gp_Pnt point;
    gp_Vec along_u;
    gp_Vec along_v;
    BRepAdaptor_Surface(face, Standard_False).D1(uv.X(), uv.Y(), point, along_u, along_v);
    return to_vec(along_u.Crossed(along_v));
}

std::vector<EdgeEnd> ends_at(const TopoDS_Face& face, const TopoDS_Vertex& vertex) {
    std::vector<EdgeEnd> ends;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        if (BRep_Tool::Degenerated(edge)) {
            continue;
        }
        TopoDS_Vertex of_edge[2];
        TopExp::Vertices(edge, of_edge[0], of_edge[1]);
        const bool inside = edge.Orientation() == TopAbs_INTERNAL;
        const bool forward = edge.Orientation() != TopAbs_REVERSED;
        for (const bool first : {true, false}) {
            if (of_edge[first ? 0 : 1].IsSame(vertex)) {
                ends.push_back({edge, first, way_into(edge, face, first), normal_at(edge, face, first),
                                inside || first == forward, inside || first != forward});
            }
        }
    }
    return ends;
}

/// From the first edge on over the face to the second, radians.
double angle_over_face(const EdgeEnd& from, const EdgeEnd& to) {
    if (from.edge.IsSame(to.edge) && from.first == to.first) {
        return 2.0 * M_PI;  // all around: a seam, or an edge inside
    }
    const double angle = angle_between(from.way, to.way);
    // Edges that touch make a corner of 0 on one side and a full turn on the other, which their directions do not tell.
    constexpr double kTouching = 1e-6;
    const bool beyond_half = from.normal.dot(from.way.cross(to.way)) < 0.0;
    return beyond_half && angle > kTouching ? 2.0 * M_PI - angle : angle;
}

}  // namespace

std::optional<double> smallest_corner(const TopoDS_Face& face, const TopoDS_Vertex& vertex) {
    const std::vector<EdgeEnd> ends = ends_at(face, vertex);
    std::optional<double> least;
    for (const EdgeEnd& from : ends) {
        for (const EdgeEnd& to : ends) {
            if (from.leaves && to.arrives) {
                least = std::min(least.value_or(2.0 * M_PI), angle_over_face(from, to));
            }
        }
    }
    return least;
}

}  // namespace mq::geometry
