// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/triangle_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mq::mesh {
namespace {

TEST(TriangleShape, TheSmallestAngleAloneIsTheSame) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        // From round to needles and caps.
        const double thin = std::pow(10.0, -7.0 * (i % 100) / 100.0);
        std::array<Vec3, 3> p;
        for (Vec3& corner : p) {
            corner = Vec3(real(random), thin * real(random), thin * real(random));
        }
        EXPECT_EQ(min_angle_of(p), shape_of(p).min_angle);
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
