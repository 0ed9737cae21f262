// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/surface_alignment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mq::triangulate {
namespace {

Vec3 leaning(double degrees) {
    return {std::sin(degrees * M_PI / 180.0), 0.0, std::cos(degrees * M_PI / 180.0)};
}

Corner corner(const Vec3& point, double degrees) {
    return {point, leaning(degrees)};
}

const Vec3 kA(0, 0, 0), kB(1, 0, 0), kC(0, 1, 0);

TEST(Alignment, IsTheCosineOfTheNormalThatDeviatesMost) {
    EXPECT_NEAR(alignment(corner(kA, 10), corner(kB, 40), corner(kC, 25)), std::cos(40.0 * M_PI / 180.0), 1e-12);
    EXPECT_NEAR(alignment(corner(kA, 0), corner(kB, 0), corner(kC, 0)), 1.0, 1e-12);
    EXPECT_NEAR(alignment(corner(kA, 0), corner(kC, 0), corner(kB, 0)), -1.0, 1e-12) << "seen from below";
}

TEST(Alignment, CornersWithoutANormalDoNotCount) {
    EXPECT_NEAR(alignment({kA, Vec3::Zero()}, corner(kB, 30), corner(kC, 0)), std::cos(M_PI / 6.0), 1e-12);
}

TEST(Alignment, OfATriangleWithoutAreaIsTheWorst) {
    EXPECT_EQ(alignment(corner(kA, 0), corner(kB, 0), corner(Vec3(2, 0, 0), 0)), -1.0);
}

TEST(Alignment, LimitsFollowTheirAngles) {
    EXPECT_NEAR(kAligned, std::cos(60.0 * M_PI / 180.0), 1e-3);
    EXPECT_NEAR(kAlignedSwap, std::cos(73.0 * M_PI / 180.0), 1e-2);
    EXPECT_NEAR(kWellAligned, std::cos(40.0 * M_PI / 180.0), 1e-3);
}

}  // namespace
}  // namespace mq::triangulate
