// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/straight_piercing.h"

#include <gtest/gtest.h>

namespace mq::curve {
namespace {

const std::array<Vec3, 3> kTriangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

TEST(StraightPiercing, IsCertainWhileEndsAndBorderAreFartherThanTheBends) {
    const Vec3 p(1, 1, -1);
    const Vec3 q(1, 1, 2);
    const std::optional<Vec3> point = certain_piercing(p, q, 0.4, kTriangle, 0.5);
    ASSERT_TRUE(point);
    EXPECT_LT((*point - Vec3(1, 1, 0)).norm(), 1e-15);
    EXPECT_TRUE(certain_piercing(q, p, 0.4, kTriangle, 0.5));
    EXPECT_FALSE(certain_piercing(p, q, 0.6, kTriangle, 0.5)) << "the curve may pass by the border";
    EXPECT_FALSE(certain_piercing(p, q, 0.0, kTriangle, 1.01)) << "the disc may pass by the end";
}

TEST(StraightPiercing, NeedsASegmentThatGoesThrough) {
    EXPECT_FALSE(certain_piercing({1, 1, 1}, {1, 1, 2}, 0.0, kTriangle, 0.0));
    EXPECT_FALSE(certain_piercing({3, 3, -1}, {3, 3, 1}, 0.0, kTriangle, 0.0));
    EXPECT_FALSE(certain_piercing({1, 1, 0}, {1, 1, 1}, 0.0, kTriangle, 0.0));
    EXPECT_FALSE(certain_piercing({0.5, 0.5, 0}, {1, 1, 0}, 0.0, kTriangle, 0.0));
}

}  // namespace
}  // namespace mq::curve
