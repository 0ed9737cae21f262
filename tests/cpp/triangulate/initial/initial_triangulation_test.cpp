// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/initial_triangulation.h"

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_GTrsf.hxx>
#include <map>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "base/predicates.h"
#include "geometry/parts.h"

namespace mq::triangulate {
namespace {

using namespace geometry;  // the shapes of its tests

constexpr double kTolerance = 1e-6;  // mm: deviation of the shapes' own edges from their surfaces

/// A shape with its structure S_C.
struct Case {
    explicit Case(const Part& part)
        : model(*part.model),
          session(engine, part.model),
          grid(part.model->topology().box),
          initial(triangulate_initially(session, grid, progress)) {}

    const geometry::Topology& topology() const { return model.topology(); }
    /// Returns the point of a site in the shape's coordinates.
    Vec3 point_of(const FaceMesh::VertexUse& site) const {
        return grid.to_shape(site.vertex >= 0 ? initial.chains.vertices()[site.vertex].point : site.point);
    }

    geometry::Model& model;
    geometry::Engine engine;
    geometry::Session session;
    SinglePrecisionGrid grid;
    Progress progress;
    InitialTriangulation initial;
};

void expect_chains_follow_curves(const Case& c) {
    const double slack = c.grid.resolution() + kTolerance;
    for (int e = 0; e < static_cast<int>(c.topology().edges.size()); ++e) {
        const EdgePolyline& chain = c.initial.chains.chain(e);
        const geometry::Edge& edge = c.topology().edges[e];
        ASSERT_EQ(chain.t.size(), chain.vertices.size());
        ASSERT_GE(chain.t.size(), 2u);
        EXPECT_EQ(chain.t.front(), edge.t0);
        EXPECT_EQ(chain.t.back(), edge.t1);
        EXPECT_EQ(chain.collapsed, edge.degenerate);
        EXPECT_EQ(chain.vertices.front(), c.initial.chains.vertex_of_node(edge.nodes[0]));
        EXPECT_EQ(chain.vertices.back(), c.initial.chains.vertex_of_node(edge.nodes[1]));
        for (std::size_t i = 0; !chain.collapsed && i < chain.t.size(); ++i) {
            const geometry::Answer here = c.model.answer(geometry::Query::edge_point(e, chain.t[i]));
            const Vec3 vertex = c.grid.to_shape(c.initial.chains.vertices()[chain.vertices[i]].point);
            EXPECT_LE((vertex - here.point).norm(), slack) << "edge " << e;
            if (i > 0) {
                EXPECT_LT(chain.t[i - 1], chain.t[i]);
                const geometry::Answer before = c.model.answer(geometry::Query::edge_point(e, chain.t[i - 1]));
                EXPECT_GE(before.normal.normalized().dot(here.normal.normalized()), std::cos(M_PI / 4.0) - 1e-9)
                    << "edge " << e << " turns by more than 45 degrees";
            }
        }
    }
}

/// Checks that every link is mutual, with opposite directions (by other sites of the same vertex where the face has a
/// pole), and that every piece of the border is used once, with the face on its left.
void expect_links(const Case& c, int f) {
    const FaceMesh& face = c.initial.faces[f];
    std::map<std::pair<int, int>, int> met;
    const auto same = [&](int a, int b) {
        return a == b || (face.sites[a].vertex >= 0 && face.sites[a].vertex == face.sites[b].vertex);
    };
    for (int h = 0; h < 3 * static_cast<int>(face.triangles.size()); ++h) {
        const auto site = [&](int k, int step) { return face.triangles[k / 3][(k % 3 + step) % 3]; };
        const FaceMesh::Link& link = face.links[h / 3][h % 3];
        ASSERT_NE(link.half_edge >= 0, link.border >= 0);
        if (link.half_edge >= 0) {
            const int g = link.half_edge;
            ASSERT_EQ(face.links[g / 3][g % 3].half_edge, h);
            ASSERT_TRUE(same(site(h, 0), site(g, 1)));
            ASSERT_TRUE(same(site(h, 1), site(g, 0)));
            continue;
        }
        const FaceMesh::Border& border = face.borders[link.border];
        const geometry::EdgeUse& use = c.topology().uses[border.use];
        const EdgePolyline& chain = c.initial.chains.chain(use.edge);
        ASSERT_EQ(use.face, f);
        ++met[{border.use, border.index}];
        const bool along = use.forward != c.topology().faces[f].reversed;
        const std::pair<int, int> side{face.sites[site(h, 0)].vertex, face.sites[site(h, 1)].vertex};
        EXPECT_EQ(side.first, chain.vertices[border.index + (along ? 0 : 1)]);
        EXPECT_EQ(side.second, chain.vertices[border.index + (along ? 1 : 0)]);
    }
    for (int u = 0; u < static_cast<int>(c.topology().uses.size()); ++u) {
        const EdgePolyline& chain = c.initial.chains.chain(c.topology().uses[u].edge);
        for (int i = 0; c.topology().uses[u].face == f && !chain.collapsed && i + 1 < int(chain.t.size()); ++i) {
            EXPECT_EQ((met[{u, i}]), 1) << "piece " << i << " of use " << u;
        }
    }
}

void expect_sites_on_surface(const Case& c, int f) {
    for (const FaceMesh::VertexUse& site : c.initial.faces[f].sites) {
        const geometry::Answer there = c.model.answer(geometry::Query::face_point(f, site.uv.x(), site.uv.y()));
        ASSERT_TRUE(there.found());
        EXPECT_LE((there.point - c.point_of(site)).norm(), c.grid.resolution() + kTolerance);
        if (there.status == geometry::Status::Ok && site.normal.squaredNorm() > 0.0) {
            EXPECT_LT((there.normal - site.normal).norm(), 1e-6);
        }
    }
}

void expect_normals(const Case& c, int f) {
    const FaceMesh& face = c.initial.faces[f];
    for (const auto& t : face.triangles) {
        const Vec3 a = c.point_of(face.sites[t[0]]);
        const Vec3 normal = (c.point_of(face.sites[t[1]]) - a).cross(c.point_of(face.sites[t[2]]) - a);
        ASSERT_GT(normal.norm(), 0.0);
        bool at_apex = false;
        double least = 1.0;
        for (const int s : t) {
            const geometry::Answer there =
                c.model.answer(geometry::Query::face_point(f, face.sites[s].uv.x(), face.sites[s].uv.y()));
            at_apex = at_apex || there.status != geometry::Status::Ok;
            least =
                there.status == geometry::Status::Ok ? std::min(least, normal.normalized().dot(there.normal)) : least;
        }
        // The normals of four triangles around the apex of a slender cone deviate more; none of the triangles faces
        // inwards.
        EXPECT_GT(least, at_apex ? 0.0 : 0.5);
    }
}

TEST(InitialTriangulation, CoversEveryFaceOfEveryPart) {
    for (const Part& part : all_parts()) {
        SCOPED_TRACE(part.name);
        const Case c(part);
        for (const auto& [face, why] : c.initial.failures) {
            ADD_FAILURE() << geometry::name_of({2, face}) << ": " << why;
        }
        ASSERT_EQ(c.initial.faces.size(), c.topology().faces.size());
        expect_chains_follow_curves(c);
        for (int f = 0; f < static_cast<int>(c.initial.faces.size()); ++f) {
            SCOPED_TRACE(geometry::name_of({2, f}));
            const FaceMesh& face = c.initial.faces[f];
            ASSERT_FALSE(face.triangles.empty());
            EXPECT_TRUE(face.failure.empty());
            EXPECT_TRUE(face.marks.empty());
            ASSERT_NO_FATAL_FAILURE(expect_links(c, f));
            ASSERT_NO_FATAL_FAILURE(expect_sites_on_surface(c, f));
            ASSERT_NO_FATAL_FAILURE(expect_normals(c, f));
        }
    }
}

/// A disc with both edges rounded off, stretched: the strips of spline surfaces are hundreds of times as long as wide,
/// and turn by a right angle across.
TopoDS_Shape stretched_disc(double fillet) {
    const TopoDS_Shape disc = BRepPrimAPI_MakeCylinder(6.5, 0.9).Shape();
    BRepFilletAPI_MakeFillet rounded(disc);
    for (TopExp_Explorer it(disc, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Current());
        if (!BRep_Tool::Degenerated(edge) && BRep_Tool::IsClosed(edge)) {
            rounded.Add(fillet, edge);
        }
    }
    gp_GTrsf stretch;
    stretch.SetValue(1, 1, 1.65);
    return BRepBuilderAPI_GTransform(rounded.Shape(), stretch).Shape();
}

TEST(InitialTriangulation, FollowsNarrowStripsThatTurnAcross) {
    for (const double fillet : {0.003, 0.01, 0.03}) {
        SCOPED_TRACE(fillet);
        const Case c(solid("stretched disc", stretched_disc(fillet)));
        ASSERT_TRUE(c.initial.failures.empty());
        ASSERT_GE(c.initial.faces.size(), 5u);
        for (const FaceMesh& face : c.initial.faces) {
            EXPECT_EQ(face.unresolved, 0) << face.triangles.size() << " triangles";
        }
    }
}

/// One arc is sampled in longer pieces than the other, and its chord cuts off the other's. If both were halved in
/// turn, that would continue to where the arcs are so close that no good triangles fit beside them.
TEST(InitialTriangulation, HalvesTheLongerOfTwoPiecesThatCross) {
    for (const double outer_turn : {27.0, 29.0, 40.0, 44.0}) {
        for (const double ratio : {1.05, 1.1, 1.2}) {
            SCOPED_TRACE(testing::Message() << outer_turn << " degrees, radii " << ratio);
            const double inner_turn = ratio * outer_turn;
            const Case c(solid("crescent", extruded(crescent(10.0, 10.0 * ratio, inner_turn, outer_turn), 5.0)));
            ASSERT_TRUE(c.initial.failures.empty());
            for (int e = 0; e < static_cast<int>(c.topology().edges.size()); ++e) {
                const EdgePolyline& chain = c.initial.chains.chain(e);
                EXPECT_LE(chain.t.size(), 5u) << "edge " << e;
            }
        }
    }
}

TEST(InitialTriangulation, IsTheSameEveryTime) {
    for (const Part& part : shape_parts()) {
        const Case a(part);
        const Case b(part);
        ASSERT_EQ(a.initial.faces.size(), b.initial.faces.size());
        for (std::size_t f = 0; f < a.initial.faces.size(); ++f) {
            EXPECT_EQ(a.initial.faces[f].triangles, b.initial.faces[f].triangles) << part.name;
        }
    }
}

void expect_same(const FaceMesh& a, const FaceMesh& b) {
    ASSERT_EQ(a.sites.size(), b.sites.size());
    for (std::size_t s = 0; s < a.sites.size(); ++s) {
        EXPECT_EQ(a.sites[s].vertex, b.sites[s].vertex);
        EXPECT_EQ(a.sites[s].uv, b.sites[s].uv);
        EXPECT_EQ(a.sites[s].normal, b.sites[s].normal);
        EXPECT_EQ(a.sites[s].point, b.sites[s].point);
    }
    EXPECT_EQ(a.triangles, b.triangles);
    ASSERT_EQ(a.links.size(), b.links.size());
    for (std::size_t t = 0; t < a.links.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(a.links[t][i].half_edge, b.links[t][i].half_edge);
            EXPECT_EQ(a.links[t][i].border, b.links[t][i].border);
        }
    }
}

TEST(InitialTriangulation, IsTheSameForAnyNumberOfThreads) {
    for (const Part& part : shape_parts()) {
        SCOPED_TRACE(part.name);
        const auto with = [&](int threads) {
            const ThreadLimit limit(threads);
            predicate_count() = {};
            return std::make_pair(std::make_unique<Case>(part), predicate_count());
        };
        const auto [one, decided] = with(1);
        for (const int threads : {2, 3, 8}) {
            const auto [several, decided_by_several] = with(threads);
            ASSERT_EQ(several->initial.chains.vertices().size(), one->initial.chains.vertices().size());
            for (std::size_t v = 0; v < one->initial.chains.vertices().size(); ++v) {
                EXPECT_EQ(several->initial.chains.vertices()[v].point, one->initial.chains.vertices()[v].point);
            }
            for (std::size_t f = 0; f < one->initial.faces.size(); ++f) {
                expect_same(several->initial.faces[f], one->initial.faces[f]);
            }
            EXPECT_EQ(several->initial.failures, one->initial.failures);
            EXPECT_EQ(several->engine.queries(), one->engine.queries());
            EXPECT_EQ(decided_by_several.filtered, decided.filtered);
            EXPECT_EQ(decided_by_several.exact, decided.exact);
        }
    }
}

TEST(InitialTriangulation, StopsWhenCancelled) {
    const auto model = geometry::make_torus(5.0, 1.5);
    geometry::Engine engine;
    geometry::Session session(engine, model);
    const SinglePrecisionGrid grid(model->topology().box);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(triangulate_initially(session, grid, progress), Cancelled);
}

TEST(EdgeDiscretisation, HalvesMarkedPiecesOnTheirCurve) {
    const auto model = make_shape_model(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape());
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    geometry::Session session(engine, model);
    const SinglePrecisionGrid grid(model->topology().box);
    EdgeDiscretisation chains(session, grid);
    for (int e = 0; e < static_cast<int>(model->topology().edges.size()); ++e) {
        const EdgePolyline before = chains.chain(e);
        EXPECT_EQ(chains.halve(session, {{e, 0}}), std::set<int>{e});
        const EdgePolyline& after = chains.chain(e);
        ASSERT_EQ(after.t.size(), before.t.size() + 1);
        EXPECT_NEAR(after.t[1], 0.5 * (before.t[0] + before.t[1]), 1e-9);  // holds for a line and for circles
        const Vec3 added = grid.to_shape(chains.vertices()[after.vertices[1]].point);
        EXPECT_LE((added - model->answer(geometry::Query::edge_point(e, after.t[1])).point).norm(), grid.resolution());
        EXPECT_EQ(after.vertices.front(), before.vertices.front());
        EXPECT_EQ(after.vertices.back(), before.vertices.back());
    }
}

/// Halves a piece until the grid prevents it, which shows by no further change.
TEST(EdgeDiscretisation, StopsWhereTheGridCannotHalve) {
    const auto model = geometry::make_box(1.0, 2.0, 3.0);
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    geometry::Session session(engine, model);
    const SinglePrecisionGrid grid(model->topology().box);
    EdgeDiscretisation chains(session, grid);
    int rounds = 0;
    while (rounds < 200 && !chains.halve(session, {{0, 0}}).empty()) {
        ++rounds;
    }
    EXPECT_GT(rounds, 10);
    EXPECT_LT(rounds, 100);
    const EdgePolyline& chain = chains.chain(0);
    for (std::size_t i = 1; i < chain.vertices.size(); ++i) {
        EXPECT_NE(chains.vertices()[chain.vertices[i - 1]].point, chains.vertices()[chain.vertices[i]].point);
    }
}

/// Faces as modellers leave them if they lost the border of an offset surface.
TEST(InitialTriangulation, FacesWithoutEdgesAreNamed) {
    BRep_Builder builder;
    TopoDS_Face bare;
    builder.MakeFace(bare, new Geom_SphericalSurface(gp_Ax3(), 1.0), 1e-7);
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, TopExp_Explorer(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(), TopAbs_FACE).Current());
    builder.Add(both, bare);
    const Case c({"bare", make_shape_model(both), 0, false});
    ASSERT_EQ(c.initial.failures.size(), 1u);
    EXPECT_EQ(c.initial.failures[0], std::make_pair(1, std::string("it has no edges")));
}

/// A square whose lower side begins with an end artefact that extends beyond the left side, farther than the
/// tolerance of their vertex.
TopoDS_Face hooked(double reach) {
    TColgp_Array1OfPnt poles(1, 6);
    const std::array<gp_Pnt, 6> at{gp_Pnt(0.0, 0.0, 0.0),      gp_Pnt(-2.0 * reach, 0.0, 0.0),
                                   gp_Pnt(-reach, reach, 0.0), gp_Pnt(3.0 * reach, reach, 0.0),
                                   gp_Pnt(0.5, 0.02, 0.0),     gp_Pnt(1.0, 0.0, 0.0)};
    for (int i = 0; i < 6; ++i) {
        poles.SetValue(i + 1, at[static_cast<std::size_t>(i)]);
    }
    const TopoDS_Edge lower = BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)).Edge();
    return planar_face({lower, line(1.0, 0.0, 1.0, 1.0), line(1.0, 1.0, 0.0, 1.0), line(0.0, 1.0, 0.0, 0.0)});
}

TEST(InitialTriangulation, HooksBeyondTheToleranceOfTheirNodeAreLeftOut) {
    const TopoDS_Face face = hooked(1e-3);
    for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next()) {
        BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), 1e-4);
    }
    const Case c({"hooked", make_shape_model(face), 0, false});
    EXPECT_TRUE(c.initial.failures.empty());
    ASSERT_EQ(c.initial.faces.size(), 1u);
    EXPECT_FALSE(c.initial.faces[0].triangles.empty());
    expect_links(c, 0);
}

/// A square of side 1 with a closed edge of radius 0.01 at one of its vertices, within the tolerance of this.
TEST(InitialTriangulation, AClosedEdgeWithinTheToleranceOfItsVertexIsAPoint) {
    const auto vertex = [](double x, double y) { return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0.0)).Vertex(); };
    const std::array<TopoDS_Vertex, 4> corners{vertex(0.0, 0.0), vertex(1.0, 0.0), vertex(1.0, 1.0), vertex(0.0, 1.0)};
    BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (std::size_t i = 0; i < 4; ++i) {
        builder.Add(wire, BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % 4]).Edge());
    }
    const gp_Circ around(gp_Ax2(gp_Pnt(1.0, 0.01, 0.0), gp::DZ(), gp_Dir(0.0, -1.0, 0.0)), 0.01);
    builder.Add(wire, BRepBuilderAPI_MakeEdge(around, corners[1], corners[1]).Edge());
    builder.UpdateVertex(corners[1], 0.05);
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), wire).Face();
    const Case c({"closed", make_shape_model(face), 0, false});
    EXPECT_TRUE(c.initial.failures.empty());
    const auto& edges = c.topology().edges;
    const auto closed = std::find_if(edges.begin(), edges.end(),
                                     [](const geometry::Edge& edge) { return edge.nodes[0] == edge.nodes[1]; });
    ASSERT_NE(closed, edges.end());
    EXPECT_TRUE(c.initial.chains.chain(static_cast<int>(closed - edges.begin())).collapsed);
    expect_links(c, 0);
}

/// On a cylinder of radius 1, a border with a degenerate edge that runs on along the next edge, and back, within the
/// tolerance of its vertex.
TEST(InitialTriangulation, ADegenerateEdgeWithinTheToleranceOfItsVertexHasOneImage) {
    const Handle(Geom_CylindricalSurface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 1.0);
    const auto image = [](double u, double v) { return gp_Pnt2d(u, v); };
    const std::array<gp_Pnt2d, 5> at{image(0.0, 0.0), image(1.0, 0.0), image(1.0, 1.0), image(0.0, 0.98),
                                     image(0.0, 1.0)};
    std::array<TopoDS_Vertex, 4> corners;
    BRep_Builder builder;
    for (std::size_t i = 0; i < 4; ++i) {
        builder.MakeVertex(corners[i], cylinder->Value(at[i].X(), at[i].Y()), i == 3 ? 0.05 : 1e-7);
    }
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (std::size_t i = 0; i < 5; ++i) {
        const gp_Pnt2d& from = at[i];
        const gp_Pnt2d& to = at[(i + 1) % 5];
        const Handle(Geom2d_Line) line = new Geom2d_Line(from, gp_Dir2d(gp_Vec2d(from, to)));
        TopoDS_Edge edge;
        builder.MakeEdge(edge);
        builder.UpdateEdge(edge, line, cylinder, TopLoc_Location(), i == 2 ? 0.05 : 1e-7);
        builder.Add(edge, corners[i == 4 ? 3 : i].Oriented(TopAbs_FORWARD));
        builder.Add(edge, corners[i == 3 ? 3 : (i + 1) % 5 % 4].Oriented(TopAbs_REVERSED));
        builder.Range(edge, 0.0, from.Distance(to));
        builder.Degenerated(edge, i == 3);
        if (i != 3) {
            BRepLib::BuildCurve3d(edge);
        }
        builder.Add(wire, edge);
    }
    TopoDS_Face face;
    builder.MakeFace(face, cylinder, 1e-7);
    builder.Add(face, wire);
    const Case c({"overlapping", make_shape_model(face), 0, false});
    EXPECT_TRUE(c.initial.failures.empty());
    ASSERT_EQ(c.initial.faces.size(), 1u);
    EXPECT_FALSE(c.initial.faces[0].triangles.empty());
    expect_links(c, 0);
}

}  // namespace
}  // namespace mq::triangulate
