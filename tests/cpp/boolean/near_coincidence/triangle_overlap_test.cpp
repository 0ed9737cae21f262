// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/triangle_overlap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mq::boolean {
namespace {

const std::array<Vec3, 3> kFloor{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

TEST(FacingTriangles, AParallelTriangleOverlapsByWhatTheyHaveInCommon) {
    const Overlap overlap = overlap_of(kFloor, {Vec3(0, 0, 0.5), Vec3(0, 2, 0.5), Vec3(2, 0, 0.5)}, 1.0);
    EXPECT_NEAR(overlap.area, 2.0, 1e-12);
    EXPECT_NEAR(overlap.low, 0.5, 1e-12);
    EXPECT_NEAR(overlap.high, 0.5, 1e-12);
    EXPECT_FALSE(overlap.same_side);
}

TEST(FacingTriangles, AreaBeyondTheReachDoesNotCount) {
    const std::array<Vec3, 3> plane{Vec3(-9, -9, 0), Vec3(19, -9, 0), Vec3(-9, 19, 0)};
    // Heights from -1 to 3 along x, of which those within 1 are from x = 0 to 4.
    const Overlap overlap = overlap_of(plane, {Vec3(0, 0, -1), Vec3(8, 0, 3), Vec3(0, 4, -1)}, 1.0);
    EXPECT_NEAR(overlap.low, -1.0, 1e-12);
    EXPECT_NEAR(overlap.high, 3.0, 1e-12);
    EXPECT_NEAR(overlap.worst, 1.0, 1e-12);
    EXPECT_NEAR(overlap.area, 0.75 * 16.0 * std::sqrt(1.25), 1e-9);
    EXPECT_TRUE(overlap.same_side);
}

TEST(FacingTriangles, SteepTrianglesDoNotFaceEachOther) {
    EXPECT_EQ(overlap_of(kFloor, {Vec3(0, 0, 0), Vec3(2, 0, 3), Vec3(0, 2, 0)}, 5.0).area, 0.0);
}

TEST(FacingTriangles, NeighboursInOnePlaneOverlapWithAMarginOnly) {
    const std::array<Vec3, 3> beside{Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(0, 4, 0)};
    EXPECT_EQ(overlap_of(kFloor, beside, 1.0).area, 0.0);
    const Overlap wider = overlap_of(kFloor, beside, 1.0, 0.1);
    EXPECT_GT(wider.area, 0.0);
    EXPECT_EQ(wider.low, 0.0);
    EXPECT_EQ(wider.high, 0.0);
}

}  // namespace
}  // namespace mq::boolean
