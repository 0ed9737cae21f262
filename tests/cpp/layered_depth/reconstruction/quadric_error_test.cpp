// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/quadric_error.h"

#include <gtest/gtest.h>

namespace mq::layered_depth {
namespace {

const Vec3 kLow(0, 0, 0), kHigh(1, 1, 1);

TEST(Quadric, ThreePlanesMeetInTheirCorner) {
    Quadric quadric;
    quadric.add({0.3, 0.9, 0.9}, Vec3::UnitX());
    quadric.add({0.9, 0.4, 0.9}, Vec3::UnitY());
    quadric.add({0.9, 0.9, 0.5}, Vec3::UnitZ());
    EXPECT_EQ(quadric.count(), 3);
    EXPECT_LT((quadric.minimiser(kLow, kHigh) - Vec3(0.3, 0.4, 0.5)).norm(), 1e-12);
}

TEST(Quadric, OnAnEdgeAndOnAPlaneThePointNearestToTheMeanIsTaken) {
    Quadric edge;
    edge.add({0.3, 0.9, 0.2}, Vec3::UnitX());
    edge.add({0.9, 0.4, 0.6}, Vec3::UnitY());
    EXPECT_LT((edge.minimiser(kLow, kHigh) - Vec3(0.3, 0.4, 0.4)).norm(), 1e-12);
    Quadric plane;
    plane.add({0.2, 0.2, 0.5}, Vec3::UnitZ());
    plane.add({0.6, 0.4, 0.5}, Vec3::UnitZ());
    EXPECT_LT((plane.minimiser(kLow, kHigh) - Vec3(0.4, 0.3, 0.5)).norm(), 1e-12);
}

TEST(Quadric, NearlyParallelPlanesThatMeetFarAwayDoNotLeaveTheBox) {
    Quadric quadric;
    quadric.add({0.2, 0.5, 0.5}, Vec3(0.02, 0.0, 1.0).normalized());
    quadric.add({0.8, 0.5, 0.52}, Vec3(-0.02, 0.0, 1.0).normalized());
    quadric.add({0.5, 0.2, 0.51}, Vec3(0.0, 0.02, 1.0).normalized());
    const Vec3 found = quadric.minimiser(kLow, kHigh);
    EXPECT_LT((found - Vec3(0.5, 0.4, 0.51)).norm(), 0.05) << found.transpose();
}

TEST(Quadric, APointJustOutsideIsPutOnTheWall) {
    Quadric quadric;
    quadric.add({1.1, 0.5, 0.5}, Vec3::UnitX());
    EXPECT_EQ(quadric.minimiser(kLow, kHigh).x(), 1.0);
}

}  // namespace
}  // namespace mq::layered_depth
