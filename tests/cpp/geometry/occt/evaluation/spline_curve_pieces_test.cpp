// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/spline_curve_pieces.h"

#include <gtest/gtest.h>

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {
namespace {

struct Kind {
    int degree;
    bool rational;
    bool periodic;
};

/// Knots at unequal steps, some of them double where the degree allows.
Handle(Geom_BSplineCurve) wavy_curve(const Kind& kind) {
    // KnotSpans of the curve.
    constexpr int kSpans = 29;
    TColStd_Array1OfReal knots(1, kSpans + 1);
    TColStd_Array1OfInteger mults(1, kSpans + 1);
    int count = -(kind.periodic ? 1 : kind.degree + 1);
    for (int i = 1; i <= kSpans + 1; ++i) {
        const bool end = i == 1 || i == kSpans + 1;
        knots(i) = i + 0.3 * std::sin(i);
        mults(i) = !kind.periodic && end ? kind.degree + 1 : (kind.degree > 1 && i % 7 == 3 ? 2 : 1);
        count += mults(i);
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<double> wave(0.2, 1.0);
    TColgp_Array1OfPnt poles(1, count);
    TColStd_Array1OfReal weights(1, count);
    for (int i = 1; i <= count; ++i) {
        poles(i) = gp_Pnt(i, 5.0 * wave(random), 3.0 * wave(random));
        weights(i) = kind.rational ? wave(random) : 1.0;
    }
    return new Geom_BSplineCurve(poles, weights, knots, mults, kind.degree, kind.periodic);
}

void expect_same(SplineCurvePieces& arcs, const Handle(Geom_BSplineCurve) & curve, double t) {
    // Size of the curve, mm.
    constexpr double kSize = 30.0;
    const double kRelative = 1e-13 + 1e-15 * std::abs(t);
    gp_Pnt p;
    gp_Vec d[2];
    curve->D2(t, p, d[0], d[1]);
    const CurvePoint found = arcs.second(t);
    EXPECT_LT((found.point - to_vec(p)).norm(), kRelative * kSize) << t;
    EXPECT_LT((found.first - to_vec(d[0])).norm(), kRelative * 10.0 * kSize) << t;
    EXPECT_LT((found.second - to_vec(d[1])).norm(), kRelative * 100.0 * kSize) << t;
    const CurvePoint alone = arcs.first(t);
    EXPECT_EQ(alone.point, found.point) << t;
    EXPECT_EQ(alone.first, found.first) << t;
}

TEST(SplineCurvePieces, AnswerAsTheCurveDoes) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (const int degree : {1, 2, 3, 5}) {
        for (const Kind& kind : {Kind{degree, false, false}, Kind{degree, true, false}, Kind{degree, false, true},
                                 Kind{degree, true, true}}) {
            SCOPED_TRACE(testing::Message()
                         << "degree " << degree << ", rational " << kind.rational << ", periodic " << kind.periodic);
            const Handle(Geom_BSplineCurve) curve = wavy_curve(kind);
            const double first = curve->FirstParameter();
            const double range = curve->LastParameter() - first;
            // A piece of the curve, one across the seam, the whole curve, and one turns away.
            const std::vector<double> starts =
                kind.periodic ? std::vector{0.0, 0.31, 0.7, -2.4, 5.2} : std::vector{0.0, 0.31, 0.5};
            for (const double from : starts) {
                const double to = kind.periodic ? from + 1.0 : std::min(1.0, from + 0.5);
                SplineCurvePieces arcs(curve, first + from * range, first + to * range);
                for (int i = 0; i < 500; ++i) {
                    expect_same(arcs, curve, first + (from + part(random) * (to - from)) * range);
                }
            }
        }
    }
}

/// At a corner inside the range the next span is evaluated, at the ends of the range the one inside.
TEST(SplineCurvePieces, ChooseTheSpanAtACorner) {
    const Handle(Geom_BSplineCurve) curve = wavy_curve({1, false, false});
    const double knots[3] = {curve->Knot(4), curve->Knot(5), curve->Knot(6)};
    SplineCurvePieces arcs(curve, knots[0], knots[2]);
    const Vec3 slopes[2] = {arcs.first(0.5 * (knots[0] + knots[1])).first,
                            arcs.first(0.5 * (knots[1] + knots[2])).first};
    ASSERT_GT((slopes[0] - slopes[1]).norm(), 0.1);
    EXPECT_LT((arcs.first(knots[0]).first - slopes[0]).norm(), 1e-12);
    EXPECT_LT((arcs.first(knots[1]).first - slopes[1]).norm(), 1e-12);
    EXPECT_LT((arcs.first(knots[2]).first - slopes[1]).norm(), 1e-12);
}

}  // namespace
}  // namespace mq::geometry
