// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/span_caches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mq::geometry {
namespace {

struct Kind {
    bool rational;
    bool periodic;
};

/// Bicubic, more spans than are kept, knots at unequal steps.
Handle(Geom_BSplineSurface) wavy_surface(const Kind& kind) {
    constexpr int kSpans[2] = {40, 25};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> wave(0.2, 1.0);
    const int poles_u = kind.periodic ? kSpans[0] : kSpans[0] + 3;
    const int poles_v = kSpans[1] + 3;
    TColgp_Array2OfPnt poles(1, poles_u, 1, poles_v);
    TColStd_Array2OfReal weights(1, poles_u, 1, poles_v);
    for (int i = 1; i <= poles_u; ++i) {
        for (int k = 1; k <= poles_v; ++k) {
            poles(i, k) = gp_Pnt(i, k + 0.1 * wave(random), 3.0 * wave(random));
            weights(i, k) = kind.rational ? wave(random) : 1.0;
        }
    }
    TColStd_Array1OfReal knots_u(1, kSpans[0] + 1);
    TColStd_Array1OfReal knots_v(1, kSpans[1] + 1);
    TColStd_Array1OfInteger mults_u(1, kSpans[0] + 1);
    TColStd_Array1OfInteger mults_v(1, kSpans[1] + 1);
    for (int i = 1; i <= kSpans[0] + 1; ++i) {
        knots_u(i) = i + 0.3 * std::sin(i);
        mults_u(i) = !kind.periodic && (i == 1 || i == kSpans[0] + 1) ? 4 : 1;
    }
    for (int k = 1; k <= kSpans[1] + 1; ++k) {
        knots_v(k) = 0.01 * k * k;
        mults_v(k) = k == 1 || k == kSpans[1] + 1 ? 4 : 1;
    }
    return new Geom_BSplineSurface(poles, weights, knots_u, knots_v, mults_u, mults_v, 3, 3, kind.periodic, false);
}

void expect_same(SpanCaches& caches, const Handle(Geom_BSplineSurface) & surface, double u, double v) {
    ASSERT_TRUE(caches.contains(u, v));
    gp_Pnt p[2];
    gp_Vec d[2][5];
    caches.at(u, v).D2(u, v, p[0], d[0][0], d[0][1], d[0][2], d[0][3], d[0][4]);
    surface->D2(u, v, p[1], d[1][0], d[1][1], d[1][2], d[1][3], d[1][4]);
    EXPECT_LT(p[0].Distance(p[1]), 1e-11) << u << ", " << v;
    for (int i = 0; i < 5; ++i) {
        EXPECT_LT((d[0][i] - d[1][i]).Magnitude(), 1e-8 * (1.0 + d[1][i].Magnitude())) << u << ", " << v << ", " << i;
    }
}

TEST(SpanCaches, AnswerAsTheSurfaceDoesInAnyOrder) {
    for (const Kind& kind : {Kind{false, false}, Kind{true, false}, Kind{false, true}, Kind{true, true}}) {
        SCOPED_TRACE(testing::Message() << "rational " << kind.rational << ", periodic " << kind.periodic);
        const Handle(Geom_BSplineSurface) surface = wavy_surface(kind);
        SpanCaches caches(surface);
        double low[2];
        double high[2];
        surface->Bounds(low[0], high[0], low[1], high[1]);
        std::mt19937 random(9);
        std::uniform_real_distribution<double> part(1e-6, 1.0 - 1e-6);
        for (int i = 0; i < 5000; ++i) {
            expect_same(caches, surface, low[0] + part(random) * (high[0] - low[0]),
                        low[1] + part(random) * (high[1] - low[1]));
        }
    }
}

/// On a knot, and beside it by less than OpenCASCADE tells apart: what is kept for one side must not serve the other.
TEST(SpanCaches, AreRightBesideKnots) {
    const Handle(Geom_BSplineSurface) surface = wavy_surface({true, false});
    SpanCaches caches(surface);
    for (int i = 2; i < surface->NbUKnots(); ++i) {
        const double knot = surface->UKnot(i);
        const double other = surface->VKnot(3) + 1e-16;
        for (const double u : {knot - 1e-15 * knot, knot, knot - 0.2, knot + 1e-15 * knot, knot + 0.2, knot}) {
            expect_same(caches, surface, u, other);
        }
    }
}

TEST(SpanCaches, LeaveTheBorderToTheAdaptor) {
    const Handle(Geom_BSplineSurface) surface = wavy_surface({false, false});
    const SpanCaches caches(surface);
    const double u = surface->UKnot(1);
    const double v = surface->VKnot(surface->NbVKnots());
    EXPECT_FALSE(caches.contains(u, 0.5 * v));
    EXPECT_FALSE(caches.contains(u + 1.0, v));
    EXPECT_TRUE(caches.contains(u + 1.0, 0.5 * v));
}

}  // namespace
}  // namespace mq::geometry
