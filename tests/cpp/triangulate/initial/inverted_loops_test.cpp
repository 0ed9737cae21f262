// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/inverted_loops.h"

#include <gtest/gtest.h>

#include "geometry/parts.h"
#include "triangulate/initial/initial_triangulation.h"

namespace mq::triangulate {
namespace {

using namespace geometry;  // the shapes of its tests

/// An arc from (0, 0) to (1, 0), with its middle at this height: one piece up to 0.06.
TopoDS_Edge bow(double height) {
    return BRepBuilderAPI_MakeEdge(
               GC_MakeArcOfCircle(gp_Pnt(0.0, 0.0, 0.0), gp_Pnt(0.5, height, 0.0), gp_Pnt(1.0, 0.0, 0.0)).Value())
        .Edge();
}

TopoDS_Wire wire_of(const std::vector<TopoDS_Edge>& edges) {
    BRepBuilderAPI_MakeWire wire;
    for (const TopoDS_Edge& edge : edges) {
        wire.Add(edge);
    }
    return wire.Wire();
}

TopoDS_Face lens(double lower, double upper) {
    return planar_face({bow(lower), bow(upper)});
}

/// A square with the lens as a hole.
TopoDS_Face window(double lower, double upper) {
    BRepBuilderAPI_MakeFace face(wire_of({line(-1.0, -1.0, 2.0, -1.0), line(2.0, -1.0, 2.0, 2.0),
                                          line(2.0, 2.0, -1.0, 2.0), line(-1.0, 2.0, -1.0, -1.0)}));
    const TopoDS_Wire hole = wire_of({bow(lower), bow(upper)});
    face.Add(TopoDS::Wire(hole.Reversed()));
    return face.Face();
}

/// A face over chains of which one was halved.
struct Case {
    explicit Case(const TopoDS_Shape& shape)
        : model(make_shape_model(shape)), session(engine, model), grid(model->topology().box), chains(session, grid) {}

    /// Returns the edge of a face whose middle has this height.
    int edge_at(double height) const {
        for (int e = 0; e < static_cast<int>(model->topology().edges.size()); ++e) {
            const geometry::Edge& edge = model->topology().edges[e];
            const Vec3 middle = model->answer(geometry::Query::edge_point(e, 0.5 * (edge.t0 + edge.t1))).point;
            if ((middle - Vec3(0.5, height, 0.0)).norm() < 1e-6) {
                return e;
            }
        }
        return -1;
    }
    std::vector<int> coarse_edges() {
        std::string failure;
        const FaceBoundary border = face_boundary(session, chains, grid, 0, failure);
        EXPECT_EQ(failure, "");
        std::vector<int> edges;
        const std::vector<std::optional<Vec2>> middles = middles_of_pieces(session, chains, border);
        for (const int piece : coarse_pieces_of_inverted_loops(session, chains, border, middles)) {
            edges.push_back(model->topology().uses[border.pieces[piece].use].edge);
        }
        return edges;
    }

    std::shared_ptr<geometry::Model> model;
    geometry::Engine engine{geometry::Engine::Mode::Direct};
    geometry::Session session;
    SinglePrecisionGrid grid;
    EdgeDiscretisation chains;
};

/// Returns the total area of the triangles in (u, v): overlapping ones count twice.
double area_of(const FaceMesh& face) {
    double area = 0.0;
    for (const auto& t : face.triangles) {
        const Vec2 a = face.sites[t[1]].uv - face.sites[t[0]].uv;
        const Vec2 b = face.sites[t[2]].uv - face.sites[t[0]].uv;
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return area;
}

TEST(InvertedLoops, AreFoundByTheirCoarserCurve) {
    for (const bool hole : {false, true}) {
        Case c(hole ? window(0.01, 0.06) : lens(0.01, 0.06));
        EXPECT_TRUE(c.coarse_edges().empty());  // coinciding chords enclose no area
        const int lower = c.edge_at(0.01);
        const int upper = c.edge_at(0.06);
        ASSERT_EQ(c.chains.halve(c.session, {{lower, 0}}).size(), 1u);
        EXPECT_EQ(c.coarse_edges(), std::vector<int>{upper});
        ASSERT_EQ(c.chains.halve(c.session, {{upper, 0}}).size(), 1u);
        EXPECT_TRUE(c.coarse_edges().empty());
    }
}

TEST(InvertedLoops, CurvesThatBulgeApartAreFine) {
    Case c(lens(-0.01, 0.06));
    ASSERT_EQ(c.chains.halve(c.session, {{c.edge_at(-0.01), 0}}).size(), 1u);
    EXPECT_TRUE(c.coarse_edges().empty());
}

/// Otherwise the triangles above the hole would end on its lower side, and those below on its upper one.
TEST(InvertedLoops, HolesOfInitialTriangulationsAreTheRightWayRound) {
    Case c(window(0.01, 0.06));
    const int lower = c.edge_at(0.01);
    ASSERT_EQ(c.chains.halve(c.session, {{lower, 0}}).size(), 1u);
    Progress progress;
    const InitialTriangulation initial =
        triangulate_the_rest(c.session, c.grid, {std::move(c.chains), {}, {}}, progress);
    ASSERT_TRUE(initial.failures.empty());
    const FaceMesh& face = initial.faces[0];
    EXPECT_LT(std::abs(area_of(face)), 9.0 - 0.02);
    const geometry::Topology& topology = c.model->topology();
    for (int h = 0; h < 3 * static_cast<int>(face.triangles.size()); ++h) {
        if (const int b = face.links[h / 3][h % 3].border; b >= 0) {
            const geometry::EdgeUse& use = topology.uses[face.borders[b].use];
            const EdgePolyline& chain = initial.chains.chain(use.edge);
            const int start =
                chain.vertices[face.borders[b].index + (use.forward != topology.faces[0].reversed ? 0 : 1)];
            EXPECT_EQ(face.sites[face.triangles[h / 3][h % 3]].vertex, start) << "edge " << use.edge;
        }
    }
}

}  // namespace
}  // namespace mq::triangulate
