// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/angle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mq {
namespace {

TEST(SmallestAngle, IsThatBetweenTheLongerSides) {
    for (const double angle : {1e-7, 0.01, 10.0, 30.0, 59.0}) {
        const double a = angle * kDegree;
        const Vec3 p(3.0 * std::cos(a), 3.0 * std::sin(a), 0.0);
        const double expected = std::pow(std::sin(a), 2);
        EXPECT_NEAR(squared_sine_of_smallest_angle(Vec3(0, 0, 0), Vec3(3, 0, 0), p) / expected, 1.0, 1e-8) << angle;
        EXPECT_NEAR(squared_sine_of_smallest_angle(p, Vec3(0, 0, 0), Vec3(3, 0, 0)) / expected, 1.0, 1e-8) << angle;
    }
}

TEST(SmallestAngle, OfTrianglesWithoutAreaIsZero) {
    EXPECT_EQ(squared_sine_of_smallest_angle(Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)), 0.0);
    EXPECT_EQ(squared_sine_of_smallest_angle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)), 0.0);
    EXPECT_EQ(squared_sine_of_smallest_angle(Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)), 0.0);
}

}  // namespace
}  // namespace mq
