// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/edges/edge_discretisation.h"

#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GC_MakeSegment.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pln.hxx>

#include "geometry/parts.h"
#include "triangulate/initial/initial_triangulation.h"

// Faces as modelers write them: within the tolerance of its nodes a border may run anywhere.
namespace mq::geometry {
namespace {

/// A corner of a planar face, and the edge from it to the next corner: a polyline, or an arc through a point.
struct Corner {
    gp_Pnt node;
    double tolerance;
    std::vector<gp_Pnt> polyline;  ///< from its start to its end, which may differ from the nodes
    bool arc = false;              ///< through the middle one of three points
};

Handle(Geom_BSplineCurve) polyline(const std::vector<gp_Pnt>& points) {
    const int n = static_cast<int>(points.size());
    TColgp_Array1OfPnt poles(1, n);
    TColStd_Array1OfReal knots(1, n);
    TColStd_Array1OfInteger multiplicities(1, n);
    double t = 0.0;
    for (int i = 1; i <= n; ++i) {
        poles(i) = points[static_cast<std::size_t>(i - 1)];
        t += i > 1 ? poles(i).Distance(poles(i - 1)) : 0.0;
        knots(i) = t;
        multiplicities(i) = i == 1 || i == n ? 2 : 1;
    }
    return new Geom_BSplineCurve(poles, knots, multiplicities, 1);
}

TopoDS_Shape face_in_plane(const std::vector<Corner>& corners) {
    BRep_Builder builder;
    std::vector<TopoDS_Vertex> nodes(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        builder.MakeVertex(nodes[i], corners[i].node, corners[i].tolerance);
    }
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::vector<gp_Pnt>& p = corners[i].polyline;
        Handle(Geom_Curve) curve = polyline(p);
        if (corners[i].arc) {
            curve = GC_MakeArcOfCircle(p[0], p[1], p[2]).Value();
        }
        TopoDS_Edge edge;
        builder.MakeEdge(edge, curve, Precision::Confusion());
        builder.Add(edge, nodes[i].Oriented(TopAbs_FORWARD));
        builder.Add(edge, nodes[(i + 1) % corners.size()].Oriented(TopAbs_REVERSED));
        builder.Range(edge, curve->FirstParameter(), curve->LastParameter());
        builder.Add(wire, edge);
    }
    TopoDS_Face face;
    builder.MakeFace(face, new Geom_Plane(gp::XOY()), Precision::Confusion());
    builder.Add(face, wire);
    return face;
}

struct Case {
    explicit Case(const TopoDS_Shape& shape)
        : model(make_shape_model(shape)),
          session(engine, model),
          grid(model->topology().box),
          initial(triangulate::triangulate_initially(session, grid, progress)) {}

    double area() const {
        double sum = 0.0;
        const triangulate::FaceMesh& face = initial.faces.front();
        for (const auto& t : face.triangles) {
            const auto point = [&](int k) {
                const triangulate::FaceMesh::VertexUse& site = face.sites[t[k]];
                return site.vertex >= 0 ? initial.chains.vertices()[site.vertex].point : site.point;
            };
            sum += 0.5 * (point(1) - point(0)).cross(point(2) - point(0)).norm();
        }
        return sum;
    }

    std::shared_ptr<Model> model;
    Engine engine{Engine::Mode::Direct};
    Session session;
    SinglePrecisionGrid grid;
    Progress progress;
    triangulate::InitialTriangulation initial;
};

gp_Pnt at(double x, double y) {
    return {x, y, 0.0};
}

/// An edge overshoots a corner, crosses the next edge and comes back, all within the corner's tolerance.
TEST(LooseNodes, HooksOfEdgesAreNotFollowed) {
    const Case c(face_in_plane({{at(0, 0), 1e-7, {at(0, 0), at(10.0004, 0.0002), at(10, 0)}},
                                {at(10, 0), 1e-3, {at(10, 0), at(10, 10)}},
                                {at(10, 10), 1e-7, {at(10, 10), at(0, 10)}},
                                {at(0, 10), 1e-7, {at(0, 10), at(0, 0)}}}));
    ASSERT_TRUE(c.initial.failures.empty()) << c.initial.failures.front().second;
    EXPECT_NEAR(c.area(), 100.0, 0.01);
    const auto& vertices = c.initial.chains.chain(0).vertices;
    const auto point = [&](int v) { return c.initial.chains.vertices()[v].point; };
    EXPECT_GE((point(vertices[vertices.size() - 2]) - point(vertices.back())).norm(), 1e-3);
}

/// The same with an overshoot below the resolution of single precision, whatever the corner's tolerance.
TEST(LooseNodes, HooksThatSinglePrecisionDoesNotShowAreNotFollowed) {
    const double hook = 4e-6;
    const Case c(face_in_plane({{at(0, 0), 1e-7, {at(0, 0), at(9.99, 0)}},
                                {at(9.99, 0), 1e-7, {at(9.99, 0), at(10, 0.5 * hook), at(10 - hook, 0)}},
                                {at(10 - hook, 0), 1e-7, {at(10 - hook, 0), at(10, 10)}},
                                {at(10, 10), 1e-7, {at(10, 10), at(0, 10)}},
                                {at(0, 10), 1e-7, {at(0, 10), at(0, 0)}}}));
    ASSERT_GT(c.grid.shortest_side(), 2.0 * hook);
    ASSERT_TRUE(c.initial.failures.empty()) << c.initial.failures.front().second;
    const auto& vertices = c.initial.chains.chain(1).vertices;
    const auto point = [&](int v) { return c.initial.chains.vertices()[v].point; };
    EXPECT_GE((point(vertices[vertices.size() - 2]) - point(vertices.back())).norm(), c.grid.shortest_side());
}

/// The edges of a corner end apart from each other, so far that the loop runs back over itself; a short edge follows.
TEST(LooseNodes, ImagesOfOneNodeAreOne) {
    const Case c(face_in_plane({{at(0, 0), 1e-7, {at(0, 0), at(10.0005, 0)}},
                                {at(10, 0), 1e-3, {at(10, 0), at(10, 0.0016)}},
                                {at(10, 0.0016), 1e-7, {at(10, 0.0016), at(10, 10)}},
                                {at(10, 10), 1e-7, {at(10, 10), at(0, 10)}},
                                {at(0, 10), 1e-7, {at(0, 10), at(0, 0)}}}));
    ASSERT_TRUE(c.initial.failures.empty()) << c.initial.failures.front().second;
    EXPECT_NEAR(c.area(), 100.0, 0.01);
}

/// Half a ring, so thin that its pieces should be halved to the end; at the ends of the inner arc they cannot be. The
/// face must be meshed nevertheless.
TEST(LooseNodes, PiecesThatCannotBeHalvedAreLeftAsTheyAre) {
    const Case c(face_in_plane({{at(10, 0), 1e-7, {at(10, 0), at(0, 10), at(-10, 0)}, true},
                                {at(-10, 0), 1e-7, {at(-10, 0), at(-9.9, 0)}},
                                {at(-9.9, 0), 2.0, {at(-9.9, 0), at(0, 9.9), at(9.9, 0)}, true},
                                {at(9.9, 0), 2.0, {at(9.9, 0), at(10, 0)}}}));
    ASSERT_TRUE(c.initial.failures.empty()) << c.initial.failures.front().second;
    const double step = M_PI / 8.0;
    // Area beyond the chords at the two ends.
    const double beyond_chords = 2.0 * 0.5 * 9.9 * 9.9 * (step - std::sin(step));
    EXPECT_NEAR(c.area(), 0.5 * M_PI * (100.0 - 9.9 * 9.9), beyond_chords);
}

}  // namespace
}  // namespace mq::geometry
