// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/spline_surface_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {
namespace {

/// Size of the surface, mm.
constexpr double kSize = 40.0;
/// Largest error relative to the size: a few hundred roundings.
constexpr double kRelative = 1e-13;

struct Kind {
    int degree[2];
    bool rational;
    bool periodic;  // periodic in u
};

/// More spans than are kept, knots at unequal steps, some of them double where the degree allows.
Handle(Geom_BSplineSurface) wavy_surface(const Kind& kind) {
    // KnotSpans in u and v, together more than are kept.
    constexpr int kSpans[2] = {40, 25};
    TColStd_Array1OfReal knots_u(1, kSpans[0] + 1);
    TColStd_Array1OfReal knots_v(1, kSpans[1] + 1);
    TColStd_Array1OfInteger mults_u(1, kSpans[0] + 1);
    TColStd_Array1OfInteger mults_v(1, kSpans[1] + 1);
    int poles_u = -(kind.periodic ? 1 : kind.degree[0] + 1);
    int poles_v = -(kind.degree[1] + 1);
    for (int i = 1; i <= kSpans[0] + 1; ++i) {
        const bool end = i == 1 || i == kSpans[0] + 1;
        knots_u(i) = i + 0.3 * std::sin(i);
        mults_u(i) = !kind.periodic && end ? kind.degree[0] + 1 : (kind.degree[0] > 1 && i % 7 == 3 ? 2 : 1);
        poles_u += mults_u(i);
    }
    for (int k = 1; k <= kSpans[1] + 1; ++k) {
        knots_v(k) = 0.3 * k + 0.01 * k * k;
        mults_v(k) = k == 1 || k == kSpans[1] + 1 ? kind.degree[1] + 1 : 1;
        poles_v += mults_v(k);
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<double> wave(0.2, 1.0);
    TColgp_Array2OfPnt poles(1, poles_u, 1, poles_v);
    TColStd_Array2OfReal weights(1, poles_u, 1, poles_v);
    for (int i = 1; i <= poles_u; ++i) {
        for (int k = 1; k <= poles_v; ++k) {
            poles(i, k) = gp_Pnt(i, k + 0.1 * wave(random), 3.0 * wave(random));
            weights(i, k) = kind.rational ? wave(random) : 1.0;
        }
    }
    return new Geom_BSplineSurface(poles, weights, knots_u, knots_v, mults_u, mults_v, kind.degree[0], kind.degree[1],
                                   kind.periodic, false);
}

std::vector<Kind> kinds() {
    std::vector<Kind> all;
    for (const auto& [u, v] : {std::pair(3, 3), std::pair(1, 2), std::pair(2, 1), std::pair(5, 3), std::pair(1, 1)}) {
        for (const bool rational : {false, true}) {
            for (const bool periodic : {false, true}) {
                all.push_back({{u, v}, rational, periodic});
            }
        }
    }
    return all;
}

bool contains(const SplineSurfacePieces& patches, double u, double v) {
    const ParameterBox box = patches.inside();
    return u > box.low[0] && u < box.high[0] && v > box.low[1] && v < box.high[1];
}

// Compares with an error relative to the size of the surface, and to its derivatives on spans of length `step`.
void expect_same(SplineSurfacePieces& patches, const Handle(Geom_BSplineSurface) & surface, double u, double v) {
    ASSERT_TRUE(contains(patches, u, v));
    gp_Pnt p;
    gp_Vec d[5];
    surface->D2(u, v, p, d[0], d[1], d[2], d[3], d[4]);
    const SurfacePoint first = patches.first(u, v);
    const SurfacePoint second = patches.second(u, v);
    const Vec3 found[5] = {second.su, second.sv, second.suu, second.svv, second.suv};
    EXPECT_LT((second.point - to_vec(p)).norm(), kRelative * kSize) << u << ", " << v;
    for (int i = 0; i < 5; ++i) {
        const double scale = kSize * (i < 2 ? 20.0 : 400.0);
        EXPECT_LT((found[i] - to_vec(d[i])).norm(), kRelative * scale) << u << ", " << v << ", " << i;
    }
    EXPECT_EQ(first.point, second.point);
    EXPECT_EQ(first.su, second.su);
    EXPECT_EQ(first.sv, second.sv);
}

TEST(SplineSurfacePieces, AnswerAsTheSurfaceDoesInAnyOrder) {
    for (const Kind& kind : kinds()) {
        SCOPED_TRACE(testing::Message() << "degrees " << kind.degree[0] << " and " << kind.degree[1] << ", rational "
                                        << kind.rational << ", periodic " << kind.periodic);
        const Handle(Geom_BSplineSurface) surface = wavy_surface(kind);
        SplineSurfacePieces patches(surface);
        double low[2];
        double high[2];
        surface->Bounds(low[0], high[0], low[1], high[1]);
        std::mt19937 random(9);
        std::uniform_real_distribution<double> part(1e-6, 1.0 - 1e-6);
        for (int i = 0; i < 2000; ++i) {
            expect_same(patches, surface, low[0] + part(random) * (high[0] - low[0]),
                        low[1] + part(random) * (high[1] - low[1]));
        }
    }
}

/// On a knot, and beside it by less than OpenCASCADE's resolution: the polynomial of one side must not be used for the
/// other. On the knot the derivatives are those of the span after it.
TEST(SplineSurfacePieces, AreRightBesideKnots) {
    for (const Kind& kind : kinds()) {
        const Handle(Geom_BSplineSurface) surface = wavy_surface(kind);
        SplineSurfacePieces patches(surface);
        for (int i = 2; i < surface->NbUKnots(); ++i) {
            const double knot = surface->UKnot(i);
            const double other = surface->VKnot(3) + 1e-15;
            for (const double u : {knot - 0.2, knot, knot + 0.2, knot}) {
                expect_same(patches, surface, u, other);
            }
            const double step = 1e-15 * knot;
            const SurfacePoint before = patches.second(knot - step, other);
            EXPECT_LT((before.point - to_vec(surface->Value(knot, other))).norm(),
                      kRelative * kSize + 2.0 * step * before.su.norm());
        }
    }
}

TEST(SplineSurfacePieces, LeaveTheBorderToTheAdaptor) {
    const Handle(Geom_BSplineSurface) surface = wavy_surface({{3, 3}, false, false});
    const SplineSurfacePieces patches(surface);
    const double u = surface->UKnot(1);
    const double v = surface->VKnot(surface->NbVKnots());
    EXPECT_FALSE(contains(patches, u, 0.5 * v));
    EXPECT_FALSE(contains(patches, u + 1.0, v));
    EXPECT_TRUE(contains(patches, u + 1.0, 0.5 * v));
}

}  // namespace
}  // namespace mq::geometry
