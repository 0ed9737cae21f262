// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <utility>

#include "geometry/parts.h"
#include "triangulate/initial/initial_triangulation.h"

namespace mq::geometry {
namespace {

/// Two squares with a sliver between them: from (0, 0) to (1, 0), with the given height in its middle.
struct Slivered {
    Slivered(double height, double tolerance) {
        const TopoDS_Vertex start = BRepBuilderAPI_MakeVertex(gp_Pnt(0.0, 0.0, 0.0)).Vertex();
        const TopoDS_Vertex end = BRepBuilderAPI_MakeVertex(gp_Pnt(1.0, 0.0, 0.0)).Vertex();
        const TopoDS_Edge lower = BRepBuilderAPI_MakeEdge(start, end).Edge();
        TColgp_Array1OfPnt poles(1, 4);  // half of its parameters lie in a third of its length
        poles.SetValue(1, gp_Pnt(1.0, 0.0, 0.0));
        poles.SetValue(2, gp_Pnt(0.95, 4.0 / 3.0 * height, 0.0));
        poles.SetValue(3, gp_Pnt(0.8, 4.0 / 3.0 * height, 0.0));
        poles.SetValue(4, gp_Pnt(0.0, 0.0, 0.0));
        const TopoDS_Edge upper = BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles), end, start).Edge();
        BRep_Builder builder;
        builder.UpdateEdge(lower, tolerance);
        builder.UpdateEdge(upper, tolerance);
        builder.MakeShell(shell);
        builder.Add(shell,
                    planar_face({lower, side(end, 1.0, -1.0), line(1.0, -1.0, 0.0, -1.0), side(start, 0.0, -1.0)}));
        builder.Add(shell, planar_face({lower, upper}));
        builder.Add(shell, planar_face({upper, side(start, 0.0, 1.0), line(0.0, 1.0, 1.0, 1.0), side(end, 1.0, 1.0)}));
    }

    static TopoDS_Edge side(const TopoDS_Vertex& from, double x, double y) {
        return BRepBuilderAPI_MakeEdge(from, BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0.0)).Vertex()).Edge();
    }

    TopoDS_Shell shell;
};

/// The edges that two faces share.
int shared_edges(const Topology& topology) {
    int count = 0;
    for (const Edge& edge : topology.edges) {
        count += edge.uses.size() == 2 ? 1 : 0;
    }
    return count;
}

TEST(CollapsedPieces, SliversWithinTheToleranceOfTheirEdgesAreOneEdge) {
    const auto model = make_shape_model(Slivered(4e-3, 5e-3).shell);
    const Topology& topology = model->topology();
    EXPECT_TRUE(topology.faces[1].no_area);
    EXPECT_EQ(shared_edges(topology), 1);
    ASSERT_FALSE(topology.faults.empty());
    EXPECT_EQ(topology.faults[0].rfind("Face2: is no wider than the tolerance of its edges", 0), 0u);

    Engine engine{Engine::Mode::Direct};
    Session session(engine, model);
    Progress progress;
    const triangulate::InitialTriangulation initial =
        triangulate::triangulate_initially(session, SinglePrecisionGrid(topology.box), progress);
    EXPECT_TRUE(initial.failures.empty());
    EXPECT_FALSE(initial.faces[0].triangles.empty());
    EXPECT_TRUE(initial.faces[1].triangles.empty());
    EXPECT_FALSE(initial.faces[2].triangles.empty());
}

/// Surfaces that are a curve, which translators write between two copies of one edge.
TEST(CollapsedPieces, SidesOfAFaceWithoutAreaAreOneEdge) {
    const TopoDS_Vertex start = BRepBuilderAPI_MakeVertex(gp_Pnt(0.0, 0.0, 0.0)).Vertex();
    const TopoDS_Vertex end = BRepBuilderAPI_MakeVertex(gp_Pnt(1.0, 0.0, 0.0)).Vertex();
    const TopoDS_Edge lower = BRepBuilderAPI_MakeEdge(start, end).Edge();
    const TopoDS_Edge upper = BRepBuilderAPI_MakeEdge(start, end).Edge();
    TColgp_Array2OfPnt poles(1, 2, 1, 2);
    for (int row = 1; row <= 2; ++row) {
        poles.SetValue(1, row, gp_Pnt(0.0, 0.0, 0.0));
        poles.SetValue(2, row, gp_Pnt(1.0, 0.0, 0.0));
    }
    const Handle(Geom_Surface) surface = new Geom_BezierSurface(poles);
    BRep_Builder builder;
    TopoDS_Face collapsed;
    builder.MakeFace(collapsed, surface, 1e-7);
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const auto& [edge, v] : {std::pair(lower, 0.0), std::pair(upper, 1.0)}) {
        const Handle(Geom2d_Line) along = new Geom2d_Line(gp_Pnt2d(0.0, v), gp_Dir2d(1.0, 0.0));
        builder.UpdateEdge(edge, along, collapsed, 1e-7);
        builder.Add(wire, edge.Oriented(v > 0.0 ? TopAbs_REVERSED : TopAbs_FORWARD));
    }
    builder.Add(collapsed, wire);
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    builder.Add(shell, planar_face({lower, Slivered::side(end, 1.0, -1.0), line(1.0, -1.0, 0.0, -1.0),
                                    Slivered::side(start, 0.0, -1.0)}));
    builder.Add(shell, collapsed);
    builder.Add(shell, planar_face({upper, Slivered::side(start, 0.0, 1.0), line(0.0, 1.0, 1.0, 1.0),
                                    Slivered::side(end, 1.0, 1.0)}));
    const auto model = make_shape_model(shell);
    EXPECT_TRUE(model->topology().faces[1].no_area);
    EXPECT_EQ(shared_edges(model->topology()), 1);
}

/// Points of the joined edge, seen from either side, lie beside each other.
TEST(CollapsedPieces, BothFacesSeeTheEdgeWhereItIs) {
    const auto model = make_shape_model(Slivered(4e-3, 5e-3).shell);
    for (const Edge& edge : model->topology().edges) {
        for (int i = 0; edge.uses.size() == 2 && i <= 200; ++i) {
            const double t = edge.t0 + (edge.t1 - edge.t0) * i / 200.0;
            const Answer a = model->answer(Query::use_on_face(edge.uses[0], t));
            const Answer b = model->answer(Query::use_on_face(edge.uses[1], t));
            ASSERT_TRUE(a.found() && b.found());
            EXPECT_LE((a.point - b.point).norm(), 5e-3) << i;
        }
    }
}

TEST(CollapsedPieces, WiderSliversStayFaces) {
    for (const double tolerance : {1e-7, 1e-3}) {
        const auto model = make_shape_model(Slivered(4e-3 + 4.0 * tolerance, tolerance).shell);
        EXPECT_FALSE(model->topology().faces[1].no_area);
        EXPECT_EQ(shared_edges(model->topology()), 2);
    }
}

}  // namespace
}  // namespace mq::geometry
