// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <memory>
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

TEST(DegenerateFaces, SliversWithinTheToleranceOfTheirEdgesAreOneEdge) {
    const auto model = make_shape_model(Slivered(4e-3, 5e-3).shell);
    const Topology& topology = model->topology();
    EXPECT_TRUE(topology.faces[1].no_area);
    EXPECT_EQ(shared_edges(topology), 1);
    ASSERT_EQ(topology.joined.size(), 1U);
    EXPECT_TRUE(topology.joined[0].by_shape);
    EXPECT_NEAR(topology.joined[0].distance, 4e-3, 1e-3);
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
TEST(DegenerateFaces, SidesOfAFaceWithoutAreaAreOneEdge) {
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
TEST(DegenerateFaces, BothFacesSeeTheEdgeWhereItIs) {
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

TEST(DegenerateFaces, WiderSliversStayFaces) {
    for (const double tolerance : {1e-7, 1e-3}) {
        const auto model = make_shape_model(Slivered(4e-3 + 4.0 * tolerance, tolerance).shell);
        EXPECT_FALSE(model->topology().faces[1].no_area);
        EXPECT_EQ(shared_edges(model->topology()), 2);
    }
}

TopoDS_Vertex vertex(double x, double y, double z) {
    return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, z)).Vertex();
}

TopoDS_Edge between(const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
    return BRepBuilderAPI_MakeEdge(from, to).Edge();
}

std::shared_ptr<Model> with_detail(const TopoDS_Shape& shape, double detail) {
    return make_shape_model(shape, nullptr, Creases::Keep, {[=](const Box&) { return detail; }, true});
}

/// A strip of 0.001 mm around a corner of a square, whose sides have two edges each.
TEST(DegenerateFaces, SliversBetweenSeveralEdgesAreThoseEdges) {
    constexpr double kWidth = 1e-3;
    const TopoDS_Vertex a[3] = {vertex(0.0, 0.0, 0.0), vertex(1.0, 0.0, 0.0), vertex(1.0, 1.0, 0.0)};
    const TopoDS_Vertex b[3] = {vertex(0.0, kWidth, 0.0), vertex(1.0 - kWidth, kWidth, 0.0),
                                vertex(1.0 - kWidth, 1.0, 0.0)};
    const TopoDS_Vertex outside[3] = {vertex(2.0, 1.0, 0.0), vertex(2.0, -1.0, 0.0), vertex(0.0, -1.0, 0.0)};
    const TopoDS_Vertex inside = vertex(0.0, 1.0, 0.0);
    const TopoDS_Edge outer[2] = {between(a[0], a[1]), between(a[1], a[2])};
    const TopoDS_Edge inner[2] = {between(b[0], b[1]), between(b[1], b[2])};
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    builder.Add(shell, planar_face({outer[0], outer[1], between(a[2], outside[0]), between(outside[0], outside[1]),
                                    between(outside[1], outside[2]), between(outside[2], a[0])}));
    builder.Add(shell, planar_face({outer[0], outer[1], between(a[2], b[2]), inner[1], inner[0], between(b[0], a[0])}));
    builder.Add(shell, planar_face({inner[0], inner[1], between(b[2], inside), between(inside, b[0])}));
    const auto model = with_detail(shell, 5.0 * kWidth);
    EXPECT_TRUE(model->topology().faces[1].no_area);
    EXPECT_EQ(shared_edges(model->topology()), 2);
    int edges_joined = 0;
    for (const Joined& joined : model->topology().joined) {
        EXPECT_FALSE(joined.by_shape);
        EXPECT_GE(joined.distance, 0.99 * kWidth);
        EXPECT_LE(joined.distance, 1.5 * kWidth);
        edges_joined += joined.entities[0].dimension == 1 ? 1 : 0;
    }
    EXPECT_EQ(edges_joined, 2);
    const auto fine = with_detail(shell, 0.5 * kWidth);
    EXPECT_FALSE(fine->topology().faces[1].no_area);
}

/// Two strips at a right angle: each has no corner beside the edge where the other one ends.
TEST(DegenerateFaces, SliversThatEndAtEachOtherAreEdges) {
    constexpr double kWidth = 1e-3;
    TopoDS_Vertex low[2] = {vertex(0.0, 0.0, 0.0), vertex(0.0, kWidth, 0.0)};
    TopoDS_Vertex middle[2] = {vertex(1.0, 0.0, 0.0), vertex(1.0, kWidth, 0.0)};
    TopoDS_Vertex high[2] = {vertex(1.0, 0.0, 1.0), vertex(1.0, kWidth, 1.0)};
    TopoDS_Edge flat[2];
    TopoDS_Edge steep[2];
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    for (int i = 0; i < 2; ++i) {
        const double y = i == 0 ? -1.0 : 1.0;
        flat[i] = between(low[i], middle[i]);
        steep[i] = between(middle[i], high[i]);
        const TopoDS_Vertex far[4] = {vertex(1.0, y, 0.0), vertex(0.0, y, 0.0), vertex(1.0, y, 1.0),
                                      vertex(1.0, y, 0.0)};
        builder.Add(shell, planar_face({flat[i], between(middle[i], far[0]), between(far[0], far[1]),
                                        between(far[1], low[i])}));
        builder.Add(shell, planar_face({steep[i], between(high[i], far[2]), between(far[2], far[3]),
                                        between(far[3], middle[i])}));
    }
    const TopoDS_Edge shared = between(middle[0], middle[1]);
    builder.Add(shell, planar_face({flat[0], shared, flat[1], between(low[1], low[0])}));
    builder.Add(shell, planar_face({steep[0], between(high[0], high[1]), steep[1], shared}));
    const auto model = with_detail(shell, 5.0 * kWidth);
    EXPECT_TRUE(model->topology().faces[4].no_area);
    EXPECT_TRUE(model->topology().faces[5].no_area);
    EXPECT_EQ(shared_edges(model->topology()), 2);
}

}  // namespace
}  // namespace mq::geometry
