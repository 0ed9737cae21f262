// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/uv_outline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mq::triangulate {
namespace {

const Triangle2 kTriangle{Vec2(0, 0), Vec2(4, 0), Vec2(0, 4)};

TEST(UvBoundary, ASegmentMeetsATriangleAlsoInAPoint) {
    EXPECT_TRUE(meets(kTriangle, {Vec2(1, 1), Vec2(9, 9)}));
    EXPECT_TRUE(meets(kTriangle, {Vec2(-1, 5), Vec2(5, -1)})) << "along its longest side";
    EXPECT_TRUE(meets(kTriangle, {Vec2(4, 0), Vec2(9, 0)})) << "in a corner";
    EXPECT_FALSE(meets(kTriangle, {Vec2(std::nextafter(4.0, 5.0), 0), Vec2(9, 0)}));
    EXPECT_FALSE(meets(kTriangle, {Vec2(3, 2), Vec2(2, 3)}));
    const Triangle2 turned{kTriangle[0], kTriangle[2], kTriangle[1]};
    EXPECT_TRUE(meets(turned, {Vec2(1, 1), Vec2(9, 9)})) << "of the other orientation";
    EXPECT_FALSE(meets(turned, {Vec2(3, 2), Vec2(2, 3)}));
}

TEST(UvBoundary, CrossingsTellInsideFromOutside) {
    // A star of five points, as many corners on the lines to them as possible.
    std::vector<Vec2> corners;
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 4.0 : 1.0;
        corners.emplace_back(radius * std::cos(0.2 * M_PI * i), radius * std::sin(0.2 * M_PI * i));
    }
    const auto inside = [&](const Vec2& p) {
        bool odd = false;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            odd = odd != crosses(p, Vec2(100.0, p.y()), {corners[i], corners[(i + 1) % corners.size()]});
        }
        return odd;
    };
    EXPECT_TRUE(inside(Vec2(0, 0))) << "on a line with two corners";
    EXPECT_TRUE(inside(Vec2(3.5, 0)));
    EXPECT_FALSE(inside(Vec2(-3.5, 0)));
    EXPECT_FALSE(inside(Vec2(2.0, 2.0)));
    for (const Vec2& corner : corners) {
        EXPECT_TRUE(inside(0.9 * corner));
        EXPECT_FALSE(inside(1.1 * corner));
    }
}

TEST(UvBoundary, InnerEdgesAreNoPartOfTheOutline) {
    FaceBoundary border;
    for (int i = 0; i < 5; ++i) {
        border.sites.push_back({i, Vec2(i, i * i), Vec3::Zero(), Vec3::Zero()});
        border.pieces.push_back({i, (i + 1) % 4, i, 0, i == 4, 0});
    }
    const std::vector<Segment2> outline = outline_of(border);
    ASSERT_EQ(outline.size(), 4u);
    EXPECT_EQ(outline[1][0], Vec2(1, 1));
    EXPECT_EQ(outline[1][1], Vec2(2, 4));
}

}  // namespace
}  // namespace mq::triangulate
