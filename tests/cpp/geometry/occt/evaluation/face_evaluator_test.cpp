// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/face_evaluator.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <cmath>
#include <random>

#include "geometry/shapes.h"

namespace mq::geometry {
namespace {

/// Radians in a turn.
constexpr double kTwoPi = 2.0 * M_PI;

/// A bumpy bicubic patch of 8 x 8 poles over [0, 7] x [0, 7].
TopoDS_Shape patch() {
    TColgp_Array2OfPnt poles(1, 8, 1, 8);
    for (int i = 1; i <= 8; ++i) {
        for (int k = 1; k <= 8; ++k) {
            poles(i, k) = gp_Pnt(i - 1.0, k - 1.0, 0.5 * std::sin(1.3 * i) * std::cos(0.9 * k));
        }
    }
    TColStd_Array1OfReal knots(1, 6);
    TColStd_Array1OfInteger multiplicities(1, 6);
    for (int i = 1; i <= 6; ++i) {
        knots(i) = i - 1.0;
        multiplicities(i) = i == 1 || i == 6 ? 4 : 1;
    }
    return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3),
                                   1e-7)
        .Shape();
}

TopoDS_Shape nurbs(const TopoDS_Shape& shape) {
    return BRepBuilderAPI_NurbsConvert(shape, Standard_True).Shape();
}

TEST(FaceNearest, FindsTheFootOnASplinePatch) {
    const auto model = make_shape_model(patch());
    std::mt19937 random(11);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const double u = 5.0 * part(random);
        const double v = 5.0 * part(random);
        const Answer here = model->answer(Query::face_point(0, u, v));
        const double height = 0.4 * (part(random) - 0.5);
        const Vec3 p = here.point + height * here.normal;
        const Answer foot =
            model->answer(Query::face_nearest(0, p, u + 0.4 * (part(random) - 0.5), v + 0.4 * (part(random) - 0.5)));
        ASSERT_EQ(foot.status, Status::Ok);
        EXPECT_NEAR(foot.u, u, 1e-8);
        EXPECT_NEAR(foot.v, v, 1e-8);
        EXPECT_NEAR(foot.distance, std::abs(height), 1e-9);
        EXPECT_LT((model->answer(Query::face_nearest_global(0, p)).point - here.point).norm(), 1e-7);
    }
}

TEST(FaceNearest, StaysOnThePatchAndOnItsBorder) {
    const auto model = make_shape_model(patch());
    const Answer beyond = model->answer(Query::face_nearest(0, Vec3(9.0, 3.0, 0.0), 4.5, 2.0));
    EXPECT_EQ(beyond.u, 5.0);
    const Answer corner = model->answer(Query::face_nearest(0, Vec3(-5.0, -5.0, 0.0), 2.5, 2.5));
    EXPECT_EQ(corner.u, 0.0);
    EXPECT_EQ(corner.v, 0.0);
    const Answer far_guess = model->answer(Query::face_nearest(0, Vec3(6.0, 6.0, 0.3), -40.0, 1e6));
    EXPECT_TRUE(far_guess.found());
    EXPECT_NEAR(far_guess.distance, model->answer(Query::face_nearest_global(0, Vec3(6.0, 6.0, 0.3))).distance, 1e-6);
}

/// Moves around the axis twice, each answer the next one's guess: (u, v) never jumps, and counts the turns.
void expect_continuous(Model& model, int face, double radius, double z) {
    double u = 0.0;
    const double period = model.topology().faces[static_cast<std::size_t>(face)].period[0];
    ASSERT_GT(period, 0.0);
    const Answer start = model.answer(Query::face_nearest_global(face, Vec3(radius, 0.0, z)));
    u = start.u;
    double v = start.v;
    // Steps in one turn.
    constexpr int kTurnSteps = 200;
    for (int i = 1; i <= 2 * kTurnSteps; ++i) {
        const double angle = kTwoPi * i / kTurnSteps;
        const Answer next =
            model.answer(Query::face_nearest(face, Vec3(radius * std::cos(angle), radius * std::sin(angle), z), u, v));
        ASSERT_TRUE(next.found());
        ASSERT_LT(std::abs(next.u - u), 0.05 * period) << "at step " << i;
        u = next.u;
        v = next.v;
    }
    EXPECT_NEAR(std::abs(u - start.u), 2.0 * period, 1e-6 * period);
    EXPECT_NEAR(v, start.v, 1e-6);
}

TEST(FaceNearest, IsContinuousAcrossSeams) {
    const TopoDS_Shape shapes[] = {BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape(),
                                   BRepPrimAPI_MakeCone(2.0, 1.0, 5.0).Shape(), BRepPrimAPI_MakeSphere(2.0).Shape(),
                                   BRepPrimAPI_MakeTorus(3.0, 1.0).Shape()};
    for (const TopoDS_Shape& shape : shapes) {
        expect_continuous(*make_shape_model(shape), 0, 2.1, 0.5);
        expect_continuous(*make_shape_model(nurbs(shape)), 0, 2.1, 0.5);
    }
}

/// A closed B-spline that is not flagged periodic is closed nevertheless, with its range for a period.
TEST(FaceNearest, WrapsClosedSplines) {
    const TopoDS_Shape cylinder = nurbs(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape());
    const auto model = make_shape_model(cylinder);
    const Face& face = model->topology().faces[0];
    ASSERT_STREQ(face.surface, "bspline");
    ASSERT_NEAR(face.period[0], face.high[0] - face.low[0], 1e-9);
    for (const double u : {0.3, 2.0, 5.9}) {
        const Answer a = model->answer(Query::face_derivatives(0, u, 1.0));
        for (const double turns : {-3.0, 1.0, 1e6}) {
            const Answer b = model->answer(Query::face_derivatives(0, u + turns * face.period[0], 1.0));
            EXPECT_LT((a.point - b.point).norm(), 1e-6);
            EXPECT_LT((a.derivatives[0] - b.derivatives[0]).norm(), 1e-6);
            EXPECT_EQ(model->answer(Query::face_contains(0, u + turns * face.period[0], 1.0)).side, 1);
        }
    }
    EXPECT_EQ(model->answer(Query::face_contains(0, 1.0, 5.01)).status, Status::BadQuery);
    EXPECT_EQ(model->answer(Query::face_contains(0, 1.0, 5.0)).side, 0);
}

TEST(FaceNearest, FindsItsWayFromAPole) {
    for (const TopoDS_Shape& shape :
         {BRepPrimAPI_MakeSphere(2.0).Shape(), nurbs(BRepPrimAPI_MakeSphere(2.0).Shape())}) {
        const auto model = make_shape_model(shape);
        const Face& face = model->topology().faces[0];
        for (const double angle : {0.1, 1.0, 2.5, 4.0, 6.0}) {
            const Vec3 p(3.0 * std::cos(angle) * 0.3, 3.0 * std::sin(angle) * 0.3, 2.0);
            const Answer foot = model->answer(Query::face_nearest(0, p, face.low[0], face.high[1]));
            ASSERT_TRUE(foot.found());
            EXPECT_LT((foot.point - 2.0 * p.normalized()).norm(), 1e-6);
        }
        // On the axis every u is equally near: the guess decides.
        const Answer top = model->answer(Query::face_nearest(0, Vec3(0.0, 0.0, 5.0), 1.0, 0.3));
        ASSERT_TRUE(top.found());
        EXPECT_LT((top.point - Vec3(0.0, 0.0, 2.0)).norm(), 1e-6);
        EXPECT_LT((top.normal - Vec3::UnitZ()).norm(), 1e-5);
    }
}

TEST(FaceContains, ReturnsForAHugeU) {
    const auto model = make_shape_model(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape());
    EXPECT_EQ(model->answer(Query::face_contains(0, 1e12, 1.0)).side, 1);
    EXPECT_EQ(model->answer(Query::face_contains(0, -1e9, 7.0)).side, -1);
    EXPECT_EQ(model->answer(Query::face_contains(0, 1e200, 1.0)).status, Status::BadQuery);
    EXPECT_EQ(model->answer(Query::face_contains(0, 0.5, 0.0)).side, 0);
}

}  // namespace
}  // namespace mq::geometry
