// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/edge_evaluator.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Elips.hxx>

#include "geometry/shapes.h"

namespace mq::geometry {
namespace {

/// A spline over [0, 1] without inner knots: a Bezier curve.
TopoDS_Edge clamped_edge(const std::vector<gp_Pnt>& points) {
    const int degree = static_cast<int>(points.size()) - 1;
    TColgp_Array1OfPnt poles(1, degree + 1);
    for (int i = 0; i <= degree; ++i) {
        poles(i + 1) = points[static_cast<std::size_t>(i)];
    }
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = 0.0;
    knots(2) = 1.0;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(degree + 1);
    return BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(poles, knots, multiplicities, degree)).Edge();
}

/// A cubic spline of four turns around the z axis, with a pitch of 1 mm.
TopoDS_Edge coil() {
    constexpr int kPoles = 33;
    TColgp_Array1OfPnt poles(1, kPoles);
    for (int i = 0; i < kPoles; ++i) {
        const double turns = 0.125 * i;
        poles(i + 1) = gp_Pnt(10.0 * std::cos(2.0 * M_PI * turns), 10.0 * std::sin(2.0 * M_PI * turns), turns);
    }
    constexpr int kSpans = kPoles - 3;
    TColStd_Array1OfReal knots(1, kSpans + 1);
    TColStd_Array1OfInteger multiplicities(1, kSpans + 1);
    for (int i = 0; i <= kSpans; ++i) {
        knots(i + 1) = i;
        multiplicities(i + 1) = i == 0 || i == kSpans ? 4 : 1;
    }
    return BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(poles, knots, multiplicities, 3)).Edge();
}

/// From the middle of the range the search ends on the turn there.
TEST(EdgeNearest, OfAllTurnsTheNearestIsFound) {
    Edge data;
    data.t1 = 30.0;
    const EdgeEvaluator edge(coil(), data);
    for (const double t : {0.5, 4.0, 11.0, 19.5, 29.0}) {
        const Vec3 point = edge.point(t).point;
        const Answer found = edge.nearest_of_all(point, 0.0, 30.0);
        EXPECT_NEAR(found.t, t, 1e-6);
        EXPECT_NEAR(found.distance, 0.0, 1e-7);
    }
    EXPECT_GT(edge.nearest(edge.point(4.0).point, 15.0, 0.0, 30.0).distance, 0.5);
}

/// A spline that runs back on itself: the guess decides which branch is found.
TEST(EdgeNearest, FollowsTheGuess) {
    BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape());
    builder.Add(both, clamped_edge({{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {4.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}));
    const auto model = make_shape_model(both);
    // Index of the spline's edge in the model.
    constexpr int kEdge = 12;
    ASSERT_EQ(model->topology().edges.size(), 13u);
    EXPECT_EQ(model->topology().faults.front(), "Edge13: belongs to no face");
    const Vec3 p(1.5, 0.5, 0.0);
    const Answer low = model->answer(Query::edge_nearest(kEdge, p, 0.1, 0.0, 1.0));
    const Answer high = model->answer(Query::edge_nearest(kEdge, p, 0.9, 0.0, 1.0));
    EXPECT_LT(low.t, 0.4);
    EXPECT_GT(high.t, 0.6);
    EXPECT_NEAR(low.distance, high.distance, 1e-9);
    // The range is binding.
    EXPECT_EQ(model->answer(Query::edge_nearest(kEdge, Vec3(1.5, 0.49, 0.0), 0.5, 0.45, 0.55)).t, 0.45);
    EXPECT_EQ(model->answer(Query::edge_nearest(kEdge, Vec3(1.5, 0.51, 0.0), 0.5, 0.45, 0.55)).t, 0.55);
    // The first crossing, though the curve comes back.
    const Answer first = model->answer(Query::edge_at_distance(kEdge, 0.0, 1.0, 2.0));
    ASSERT_TRUE(first.found());
    EXPECT_NEAR(first.point.norm(), 2.0, 1e-12);
    EXPECT_LT(first.t, 0.5);
    EXPECT_EQ(model->answer(Query::edge_at_distance(kEdge, 0.0, 1.0, 9.0)).status, Status::NotFound);
    // Middle by arc length.
    const Answer middle = model->answer(Query::edge_middle(kEdge, 0.0, 0.6));
    EXPECT_NEAR(model->answer(Query::edge_length(kEdge, 0.0, middle.t)).distance,
                model->answer(Query::edge_length(kEdge, 0.6, middle.t)).distance, 1e-8);
    EXPECT_NEAR(model->answer(Query::edge_middle(kEdge, 0.6, 0.0)).t, middle.t, 1e-8);
}

/// A curve whose speed is 0 at its end but for rounding: x = t * t.
TEST(EdgeNearest, FindsAnEndWhereTheCurveStandsStill) {
    for (const double rounding : {0.0, 1e-14, -1e-14, 1e-12}) {
        const TopoDS_Edge edge = clamped_edge({{0.0, 0.0, 0.0}, {rounding, 0.0, 0.0}, {1.0, 0.0, 0.0}});
        const auto model = make_shape_model(BRepPrimAPI_MakePrism(edge, gp_Vec(0.0, 1.0, 0.0)).Shape());
        int found = -1;
        for (int e = 0; e < 4; ++e) {
            const Answer middle = model->answer(Query::edge_point(e, 0.5));
            found = middle.found() && std::abs(middle.point.x() - 0.25) < 1e-9 ? e : found;
        }
        ASSERT_GE(found, 0);
        const double y = model->answer(Query::edge_point(found, 0.5)).point.y();
        for (const double off : {0.0, 1e-13, -1e-13, 1e-6, -1e-6}) {
            for (const double guess : {0.0, 1e-9, 0.1, 0.5, 1.0}) {
                const Answer end = model->answer(Query::edge_nearest(found, Vec3(off, y, 0.0), guess, 0.0, 1.0));
                EXPECT_LT(end.distance, 1.001e-6) << off << " from " << guess << " with " << rounding;
            }
        }
    }
}

/// Parameters of an ellipse go on over its vertex, at (5, 0, 0).
TEST(ClosedEdge, GoesOnOverItsEnd) {
    const gp_Elips ellipse(gp_Ax2({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), 5.0, 3.0);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(ellipse).Edge();
    const auto model = make_shape_model(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge).Wire()).Face());
    ASSERT_EQ(model->topology().edges.size(), 1u);
    const double turn = model->topology().edges[0].t1;
    const auto point = [&](double t) { return model->answer(Query::edge_point(0, t)); };
    EXPECT_LT((point(turn + 0.3).point - point(0.3).point).norm(), 1e-12);
    EXPECT_LT((point(-0.3).point - point(turn - 0.3).point).norm(), 1e-12);
    EXPECT_EQ(point(turn + 0.3).t, turn + 0.3);
    EXPECT_EQ(point(2.1 * turn).status, Status::BadQuery);
    const auto length = [&](double a, double b) { return model->answer(Query::edge_length(0, a, b)).distance; };
    EXPECT_NEAR(length(turn - 0.4, turn + 0.3), length(turn - 0.4, turn) + length(0.0, 0.3), 1e-9);
    EXPECT_NEAR(length(0.3, -0.4), length(turn - 0.4, turn) + length(0.0, 0.3), 1e-9);
    const Answer middle = model->answer(Query::edge_middle(0, turn - 0.4, turn + 0.3));
    EXPECT_NEAR(length(turn - 0.4, middle.t), length(middle.t, turn + 0.3), 1e-8);
    const Answer nearest = model->answer(Query::edge_nearest(0, point(0.2).point, turn, turn - 0.4, turn + 0.3));
    EXPECT_NEAR(nearest.t, turn + 0.2, 1e-9);
    EXPECT_NEAR(nearest.distance, 0.0, 1e-9);
    const Answer at_end = model->answer(Query::edge_nearest(0, point(0.9).point, turn, turn - 0.4, turn + 0.3));
    EXPECT_NEAR(at_end.t, turn + 0.3, 1e-9);
    const Answer on_face = model->answer(Query::use_on_face(0, turn + 0.3));
    ASSERT_TRUE(on_face.found());
    EXPECT_LT((on_face.point - point(0.3).point).norm(), 1e-9);
}

}  // namespace
}  // namespace mq::geometry
