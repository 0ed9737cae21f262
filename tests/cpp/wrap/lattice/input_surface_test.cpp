// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/lattice/input_surface.h"

#include <gtest/gtest.h>

#include <random>

namespace mq::wrap {
namespace {

const std::vector<Vec3> kPoints{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}};
const std::vector<mesh::Triangle> kTriangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};

TEST(InputSurface, NothingPassesTheEdgeBetweenTriangles) {
    const InputSurface surface(kPoints, kTriangles);
    EXPECT_TRUE(surface.meets({1, 1, -1}, {1, 1, 0.5}));    // through the common edge
    EXPECT_TRUE(surface.meets({0, 0, -1}, {0, 0, 0.5}));    // through the common vertex
    EXPECT_TRUE(surface.meets({0.5, 1, -1}, {0.5, 1, 0}));  // it ends on the triangle
    EXPECT_FALSE(surface.meets({0.5, 1, -1}, {0.5, 1, -1e-300}));
    EXPECT_FALSE(surface.meets({2.5, 1, -1}, {2.5, 1, 3}));
}

TEST(InputSurface, FirstMeetingDependsOnTheDirection) {
    const InputSurface surface(kPoints, kTriangles);
    const FirstMeeting up = surface.first_meeting({1.5, 1, -1}, {1.5, 1, 3});
    EXPECT_EQ(up.triangle, 0);
    EXPECT_DOUBLE_EQ(up.share, 0.25);
    const FirstMeeting down = surface.first_meeting({1.5, 1, 3}, {1.5, 1, -1});
    EXPECT_EQ(down.triangle, 2);
    EXPECT_DOUBLE_EQ(down.share, 0.5);
    EXPECT_GT(surface.first_meeting({1.5, 1, 2}, {1.5, 1, 3}).share, 1.0);
    EXPECT_EQ(surface.normal(0), Vec3(0, 0, 1));
}

TEST(InputSurface, SegmentsOfAFanMeetWhatEachOfThemMeets) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0.0, 4.0);
    const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
    std::vector<Vec3> points;
    std::vector<mesh::Triangle> triangles;
    for (std::int32_t k = 0; k < 40; ++k) {
        points.insert(points.end(), {point(), point(), point()});
        triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    const InputSurface surface(points, triangles);
    int meeting = 0;
    for (int round = 0; round < 200; ++round) {
        Fan fan{point()};
        for (; fan.count < static_cast<std::size_t>(round) % (Fan::kMostSegments + 1); ++fan.count) {
            fan.to[fan.count] = fan.from + 0.2 * (point() - fan.from);
        }
        const unsigned met = surface.met_of(fan);
        EXPECT_EQ(met >> fan.count, 0U);
        for (std::size_t k = 0; k < fan.count; ++k) {
            EXPECT_EQ((met >> k & 1U) != 0, surface.first_meeting(fan.from, fan.to[k]).triangle >= 0);
            meeting += static_cast<int>(met >> k & 1U);
        }
    }
    EXPECT_GT(meeting, 50);
}

}  // namespace
}  // namespace mq::wrap
