// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/exact/exact_constrained_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace mq::boolean {
namespace {

/// A point of the plane x + y + z = 12, chosen so that seen along any axis it is a grid point.
Vec3 on_plane(int x, int y) {
    return Vec3(x, y, 12 - x - y);
}

/// A segment of the plane that ends at two of its points, as the cut of a plane that stands on it.
Line cut(const Vec3& a, const Vec3& b) {
    Line line;
    line.plane = {a, b, a + Vec3(1, 2, 4)};
    return line;
}

class PlaneDivisionTest : public testing::TestWithParam<int> {
  protected:
    PlaneDivisionTest() : division_({on_plane(0, 0), on_plane(12, 0), on_plane(0, 12)}, GetParam(), 1) {
        for (const Vec3& p : {on_plane(0, 0), on_plane(12, 0), on_plane(0, 12)}) {
            division_.add_point(ExactPoint(p));
        }
        division_.start(0, 1, 2);
    }

    int add(int x, int y) { return division_.insert(division_.add_point(ExactPoint(on_plane(x, y)))); }
    void constrain(int a, int b) {
        const auto& p = division_.points();
        const Line line = cut(p[static_cast<std::size_t>(a)].approx(), p[static_cast<std::size_t>(b)].approx());
        division_.constrain(a, b, division_.add_line(line));
    }
    /// All triangles run counter-clockwise and together have the area of the first one.
    void expect_valid() const {
        double area = 0.0;
        for (const auto& t : division_.triangles()) {
            const ExactPoint& a = division_.points()[static_cast<std::size_t>(t[0])];
            const ExactPoint& b = division_.points()[static_cast<std::size_t>(t[1])];
            const ExactPoint& c = division_.points()[static_cast<std::size_t>(t[2])];
            ASSERT_GT(orient2d(a, b, c, GetParam()), 0);
            area += 0.5 * (b.approx() - a.approx()).cross(c.approx() - a.approx()).norm();
        }
        EXPECT_NEAR(area, 72.0 * std::sqrt(3.0), 1e-9);
    }
    bool has_edge(int a, int b) const {
        for (const auto& t : division_.triangles()) {
            for (std::size_t k = 0; k < 3; ++k) {
                if ((t[k] == a && t[(k + 1) % 3] == b) || (t[k] == b && t[(k + 1) % 3] == a)) {
                    return true;
                }
            }
        }
        return false;
    }

    ExactConstrainedTriangulation division_;
};

INSTANTIATE_TEST_SUITE_P(Axes, PlaneDivisionTest, testing::Values(0, 1, 2));

TEST_P(PlaneDivisionTest, InsertsInFacesOnEdgesAndAtPoints) {
    const int inside = add(3, 3);
    const int on_edge = add(6, 0);
    EXPECT_EQ(add(3, 3), inside);
    EXPECT_EQ(add(0, 0), 0);
    EXPECT_NE(on_edge, inside);
    EXPECT_EQ(division_.triangles().size(), 4u);
    expect_valid();
}

TEST_P(PlaneDivisionTest, SegmentsBecomeEdges) {
    const int a = add(1, 1);
    const int b = add(8, 3);
    for (int i = 0; i < 6; ++i) {
        add(2 + i, 1 + i % 4);
    }
    constrain(a, b);
    expect_valid();
    EXPECT_TRUE(has_edge(a, b));
    division_.improve();
    expect_valid();
    EXPECT_TRUE(has_edge(a, b)) << "a constraint was swapped away";
}

TEST_P(PlaneDivisionTest, APointOnASegmentDividesIt) {
    const int a = add(1, 1);
    const int middle = add(3, 2);
    const int b = add(5, 3);
    constrain(a, b);
    EXPECT_TRUE(has_edge(a, middle));
    EXPECT_TRUE(has_edge(middle, b));
    EXPECT_FALSE(has_edge(a, b));
    expect_valid();
}

TEST_P(PlaneDivisionTest, CrossingSegmentsMeetInANewPoint) {
    const int a = add(1, 1);
    const int b = add(6, 3);
    const int c = add(2, 4);
    const int d = add(4, 1);
    constrain(a, b);
    const std::size_t before = division_.points().size();
    constrain(c, d);
    ASSERT_EQ(division_.points().size(), before + 1);
    const int x = static_cast<int>(before);
    for (const int end : {a, b, c, d}) {
        EXPECT_TRUE(has_edge(end, x));
    }
    // (1, 1) + s (5, 2) = (4, 1) + t (-2, 3): s = 9 / 19.
    EXPECT_NEAR(division_.points().back().approx().x(), 1.0 + 45.0 / 19.0, 1e-14);
    EXPECT_NEAR(division_.points().back().approx().y(), 1.0 + 18.0 / 19.0, 1e-14);
    expect_valid();
}

TEST_P(PlaneDivisionTest, ManySegmentsOfAGridStayExact) {
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round) {
        const auto pick = [&] {
            for (;;) {
                const int x = static_cast<int>(random() % 13);
                const int y = static_cast<int>(random() % 13);
                if (x + y <= 12) {
                    return add(x, y);
                }
            }
        };
        const int a = pick();
        const int b = pick();
        if (a != b) {
            constrain(a, b);
        }
    }
    expect_valid();
    division_.improve();
    expect_valid();
}

}  // namespace
}  // namespace mq::boolean
