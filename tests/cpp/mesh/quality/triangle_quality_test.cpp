// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/triangle_quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mq::mesh {
namespace {

TEST(TriangleShape, TheSmallestAngleAloneIsTheSame) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        // Shapes from round to needles and caps.
        const double thin = std::pow(10.0, -7.0 * (i % 100) / 100.0);
        std::array<Vec3, 3> p;
        for (Vec3& corner : p) {
            corner = Vec3(real(random), thin * real(random), thin * real(random));
        }
        EXPECT_EQ(min_angle_of(p), shape_of(p).min_angle);
    }
}

TEST(TriangleShape, IsTheSameAtAnySize) {
    const std::array<Vec3, 3> p{Vec3(0, 0, 0), Vec3(std::sqrt(3.0), 0, 0), Vec3(0, 0, 1)};
    const std::array<Vec3, 3> straight{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
    for (const double size : {1e308, 1e300, 1e155, 1e70, 1e-70, 1e-155, 1e-300}) {
        const TriangleShape shape = shape_of({size * p[0], size * p[1], size * p[2]});
        EXPECT_NEAR(shape.min_angle, 30.0, 1e-12) << size;
        EXPECT_NEAR(shape.max_angle, 90.0, 1e-12) << size;
        EXPECT_NEAR(shape.aspect, 2.0, 1e-12) << size;
        EXPECT_NEAR(shape.distortion, 8.0 / (4.0 * std::sqrt(3.0) * std::sqrt(3.0) / 2.0), 1e-12) << size;
        EXPECT_EQ(min_angle_of({size * p[0], size * p[1], size * p[2]}), shape.min_angle) << size;
        EXPECT_TRUE(
            shape_of({0.5 * size * straight[0], 0.5 * size * straight[1], 0.5 * size * straight[2]}).degenerate);
    }
    // What is too large for a number is infinite, what is too small is 0.
    EXPECT_EQ(shape_of({1e300 * p[0], 1e300 * p[1], 1e300 * p[2]}).area, HUGE_VAL);
    EXPECT_NEAR(shape_of({1e100 * p[0], 1e100 * p[1], 1e100 * p[2]}).area / 1e200, 0.5 * std::sqrt(3.0), 1e-12);
    EXPECT_EQ(shape_of({1e-200 * p[0], 1e-200 * p[1], 1e-200 * p[2]}).area, 0.0);
}

TEST(TriangleShape, OfShortSidesFarFromTheOriginIsKnown) {
    for (const double size : {1e-100, 1e-200, 1e-300}) {
        const TriangleShape shape = shape_of({Vec3(1, 0, 0), Vec3(1, size, 0), Vec3(1, 0, size)});
        EXPECT_NEAR(shape.min_angle, 45.0, 1e-12) << size;
        EXPECT_NEAR(shape.max_angle, 90.0, 1e-12) << size;
        EXPECT_FALSE(shape.degenerate) << size;
    }
}

TEST(TriangleShape, AnglesOfKnownTriangles) {
    EXPECT_NEAR(min_angle_of({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}), 45.0, 1e-12);
    EXPECT_NEAR(min_angle_of({Vec3(0, 0, 0), Vec3(std::sqrt(3.0), 0, 0), Vec3(0, 0, 1)}), 30.0, 1e-12);
    EXPECT_EQ(min_angle_of({Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)}), 0.0);
    EXPECT_EQ(min_angle_of({Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(0, 0, 1)}), 0.0);
}

}  // namespace
}  // namespace mq::mesh
