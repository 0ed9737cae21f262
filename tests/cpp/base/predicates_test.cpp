// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "base/cases.h"
#include "base/exact.h"
#include "base/point_source.h"

namespace mq {
namespace {

/// Cases of a quick predicate.
constexpr int kCheap = scaled_cases(100000);
/// Cases of a predicate whose definition takes long in rational arithmetic.
constexpr int kCostly = scaled_cases(20000);

/// Every predicate against its definition in rational arithmetic, on every kind of points.
class PredicatesTest : public testing::TestWithParam<Points> {
  protected:
    PointSource source(std::uint64_t seed) const { return PointSource(GetParam(), seed); }
};

INSTANTIATE_TEST_SUITE_P(Points, PredicatesTest, testing::ValuesIn(kAllPoints),
                         [](const auto& parameter) { return name_of(parameter.param); });

TEST_P(PredicatesTest, SignDotIsExact) {
    PointSource points = source(1);
    for (int i = 0; i < kCheap; ++i) {
        const std::vector<Vec3> v = points.take(3);
        const int expected = exact::sign_dot(v[0], v[1], v[2]);
        ASSERT_EQ(sign_dot(v[0], v[1], v[2]), expected) << "case " << i;
        ASSERT_EQ(encroached(v[1], v[2], v[0]), expected < 0) << "case " << i;
    }
}

TEST_P(PredicatesTest, ObtuseVertexIsExact) {
    PointSource points = source(2);
    for (int i = 0; i < kCostly; ++i) {
        const std::vector<Vec3> v = points.take(3);
        int expected = -1;
        for (int k = 0; k < 3; ++k) {
            if (exact::sign_dot(v[k], v[(k + 1) % 3], v[(k + 2) % 3]) < 0) {
                ASSERT_EQ(expected, -1) << "two obtuse angles in case " << i;
                expected = k;
            }
        }
        ASSERT_EQ(obtuse_vertex(v[0], v[1], v[2]), expected) << "case " << i;
    }
}

TEST_P(PredicatesTest, LocallyMaxminIsExactAndSymmetric) {
    PointSource points = source(5);
    for (int i = 0; i < kCostly; ++i) {
        const std::vector<Vec3> v = points.take(4);
        const bool keep = locally_maxmin(v[0], v[1], v[2], v[3]);
        ASSERT_EQ(keep, exact::locally_maxmin(v[0], v[1], v[2], v[3])) << "case " << i;
        ASSERT_EQ(locally_maxmin(v[1], v[0], v[3], v[2]), keep) << "case " << i;
        ASSERT_EQ(locally_maxmin(v[1], v[0], v[2], v[3]), keep) << "case " << i;
        ASSERT_TRUE(keep || locally_maxmin(v[2], v[3], v[1], v[0])) << "case " << i;
    }
}

TEST_P(PredicatesTest, Orient2dIsExactAndAntisymmetric) {
    PointSource points = source(6);
    for (int i = 0; i < kCheap; ++i) {
        const std::vector<Vec2> v = points.take_plane(3);
        const int sign = orient2d(v[0], v[1], v[2]);
        ASSERT_EQ(sign, exact::orient2d(v[0], v[1], v[2])) << "case " << i;
        ASSERT_EQ(orient2d(v[1], v[2], v[0]), sign) << "case " << i;
        ASSERT_EQ(orient2d(v[1], v[0], v[2]), -sign) << "case " << i;
    }
}

TEST_P(PredicatesTest, InCircleIsExactAndAntisymmetric) {
    PointSource points = source(7);
    for (int i = 0; i < kCheap; ++i) {
        const std::vector<Vec2> v = points.take_plane(4);
        const int sign = in_circle(v[0], v[1], v[2], v[3]);
        ASSERT_EQ(sign, exact::in_circle(v[0], v[1], v[2], v[3])) << "case " << i;
        ASSERT_EQ(in_circle(v[1], v[0], v[2], v[3]), -sign) << "case " << i;
        ASSERT_EQ(in_circle(v[1], v[2], v[3], v[0]), -sign) << "case " << i;
    }
}

TEST_P(PredicatesTest, Orient3dIsExactAndAntisymmetric) {
    PointSource points = source(9);
    for (int i = 0; i < kCheap; ++i) {
        std::vector<Vec3> v = points.take(4);
        if (i % 4 == 0) {
            v[3] = 0.5 * (v[0] + v[1] + v[2] - v[i / 4 % 3]);  // in the plane, or nearly so
        }
        const int sign = orient3d(v[0], v[1], v[2], v[3]);
        ASSERT_EQ(sign, exact::orient3d(v[0], v[1], v[2], v[3])) << "case " << i;
        ASSERT_EQ(orient3d(v[1], v[2], v[0], v[3]), sign) << "case " << i;
        ASSERT_EQ(orient3d(v[1], v[0], v[2], v[3]), -sign) << "case " << i;
        ASSERT_EQ(orient3d(v[3], v[1], v[2], v[0]), -sign) << "case " << i;
    }
}

TEST_P(PredicatesTest, InSphereIsExactAndAntisymmetric) {
    PointSource points = source(12);
    for (int i = 0; i < kCostly; ++i) {
        std::vector<Vec3> v = points.take(5);
        if (i % 4 == 0) {
            v[4] = v[0] + v[1] - v[2];  // on the sphere where these four make a rectangle
        }
        const int sign = in_sphere(v[0], v[1], v[2], v[3], v[4]);
        ASSERT_EQ(sign, exact::in_sphere(v[0], v[1], v[2], v[3], v[4])) << "case " << i;
        ASSERT_EQ(in_sphere(v[1], v[0], v[2], v[3], v[4]), -sign) << "case " << i;
        ASSERT_EQ(in_sphere(v[1], v[2], v[0], v[3], v[4]), sign) << "case " << i;
    }
}

TEST(Predicates, InSphereIsPositiveInside) {
    const std::array<Vec3, 4> v{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    ASSERT_GT(orient3d(v[0], v[1], v[2], v[3]), 0);
    EXPECT_EQ(in_sphere(v[0], v[1], v[2], v[3], Vec3(0.2, 0.2, 0.2)), 1);
    EXPECT_EQ(in_sphere(v[0], v[1], v[2], v[3], Vec3(1.0, 1.0, 1.0)), 0);
    EXPECT_EQ(in_sphere(v[0], v[1], v[2], v[3], Vec3(1.0, 1.0, std::nextafter(1.0, 2.0))), -1);
    EXPECT_EQ(in_sphere(v[0], v[1], v[2], v[3], Vec3(1.0, 1.0, std::nextafter(1.0, 0.0))), 1);
}

TEST_P(PredicatesTest, CollinearIsExact) {
    PointSource points = source(10);
    for (int i = 0; i < kCheap; ++i) {
        const std::vector<Vec3> v = points.take(3);
        ASSERT_EQ(collinear(v[0], v[1], v[2]), exact::collinear(v[0], v[1], v[2])) << "case " << i;
    }
}

// Differences that fit 41 bits are multiplied as integers; those that just do not, as expansions.
TEST(Predicates, Orient3dOfSinglePrecisionIsExact) {
    std::mt19937 dice(11);
    std::uniform_int_distribution<int> mantissa(-(1 << 23), 1 << 23);
    std::uniform_int_distribution<int> bits(-24, 24);
    for (int i = 0; i < scaled_cases(20000); ++i) {
        const int spread = i % 5 == 0 ? 1 : 0;
        const auto number = [&] { return std::ldexp(static_cast<double>(mantissa(dice)), spread * bits(dice)); };
        std::array<Vec3, 4> v;
        for (Vec3& p : v) {
            p = Vec3(number(), number(), number());
        }
        if (i % 2 == 0) {
            v[3] = v[0] + 4.0 * (v[1] - v[0]) - 2.0 * (v[2] - v[0]);  // in the plane where nothing is rounded
        }
        if (i % 6 == 0) {
            v[3].z() += std::ldexp(1.0, bits(dice));
        }
        ASSERT_EQ(orient3d(v[0], v[1], v[2], v[3]), exact::orient3d(v[0], v[1], v[2], v[3])) << "case " << i;
    }
}

TEST(Predicates, Orient3dIsPositiveOnTheSideOfTheNormal) {
    const Vec3 a(0, 0, 1);
    const Vec3 b(1, 0, 1);
    const Vec3 c(0, 1, 1);
    EXPECT_EQ(orient3d(a, b, c, Vec3(0.3, 0.3, 1.5)), 1);
    EXPECT_EQ(orient3d(a, b, c, Vec3(0.3, 0.3, 0.5)), -1);
    EXPECT_EQ(orient3d(a, b, c, Vec3(7, -3, 1)), 0);
    EXPECT_EQ(orient3d(a, b, a, Vec3(0.3, 0.3, 1.5)), 0);
}

TEST(Predicates, CollinearTrianglesHaveAnglesOfZeroAndPi) {
    const Vec3 a(0.1, 0.1, 0.1);
    const Vec3 b(0.2, 0.2, 0.2);
    const Vec3 c(0.7, 0.7, 0.7);
    EXPECT_EQ(obtuse_vertex(a, b, c), 1);
    // A degenerate pair is never kept when the swap yields two real triangles.
    EXPECT_FALSE(locally_maxmin(Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(1, 0, 0), Vec3(1, -1, 0)));
    EXPECT_TRUE(locally_maxmin(Vec3(1, 0, 0), Vec3(1, -1, 0), Vec3(0, 0, 0), Vec3(2, 0, 0)));
    EXPECT_TRUE(locally_maxmin(a, b, c, a));
}

TEST(Predicates, TiesOfASquareKeepEitherDiagonal) {
    const Vec3 a(0, 0, 0.3);
    const Vec3 b(0.1, 0, 0.3);
    const Vec3 c(0.1, 0.1, 0.3);
    const Vec3 d(0, 0.1, 0.3);
    EXPECT_TRUE(locally_maxmin(a, c, d, b));
    EXPECT_TRUE(locally_maxmin(d, b, c, a));
    EXPECT_EQ(sign_dot(a, b, d), 0);
    EXPECT_FALSE(encroached(b, d, a));
    EXPECT_EQ(in_circle(a.head<2>(), b.head<2>(), c.head<2>(), d.head<2>()), 0);
}

TEST(Predicates, CountHowTheyDecided) {
    const PredicateCount before = predicate_count();
    sign_dot(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0));
    sign_dot(Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(1, -1, 0));
    EXPECT_EQ(predicate_count().filtered, before.filtered + 1);
    EXPECT_EQ(predicate_count().exact, before.exact + 1);
}

TEST(Predicates, TheFilterDecidesRandomPoints) {
    PointSource points(Points::kRandom, 8);
    const PredicateCount before = predicate_count();
    for (int i = 0; i < kCostly; ++i) {
        const std::vector<Vec3> v = points.take(4);
        locally_maxmin(v[0], v[1], v[2], v[3]);
    }
    EXPECT_EQ(predicate_count().exact, before.exact);
}

}  // namespace
}  // namespace mq
