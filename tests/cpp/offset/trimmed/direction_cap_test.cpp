// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/trimmed/direction_cap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/corner_table.h"

namespace mq::offset {
namespace {

double area(const DirectionCap& cap) {
    double sum = 0.0;
    for (const mesh::Triangle& t : cap.triangles) {
        const Vec3& a = cap.directions[static_cast<std::size_t>(t[0])];
        const Vec3& b = cap.directions[static_cast<std::size_t>(t[1])];
        const Vec3& c = cap.directions[static_cast<std::size_t>(t[2])];
        sum += 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    return sum;
}

/// Directions on great circles between others, each in as many steps.
std::vector<Vec3> loop_through(const std::vector<Vec3>& corners, int steps) {
    std::vector<Vec3> loop;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (int k = 0; k < steps; ++k) {
            loop.push_back(on_arc(corners[i], corners[(i + 1) % corners.size()], static_cast<double>(k) / steps));
        }
    }
    return loop;
}

std::size_t borders(const DirectionCap& cap) {
    std::size_t count = 0;
    for (const std::int32_t twin : mesh::edge_twins(cap.triangles, cap.directions.size())) {
        count += twin == mesh::kBorder ? 1 : 0;
    }
    return count;
}

TEST(DirectionCap, ACornerOfABoxIsAnOctant) {
    const auto loop = loop_through({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, 6);
    const DirectionCap cap = cap_over(loop, Vec3(1, 1, 1), M_PI / 2.0, 0.27);
    EXPECT_NEAR(area(cap), M_PI / 2.0, 1e-12);
    EXPECT_EQ(borders(cap), loop.size());
    for (const mesh::Triangle& t : cap.triangles) {
        const Vec3& a = cap.directions[static_cast<std::size_t>(t[0])];
        const Vec3& b = cap.directions[static_cast<std::size_t>(t[1])];
        const Vec3& c = cap.directions[static_cast<std::size_t>(t[2])];
        EXPECT_GT(a.dot(b.cross(c)), 0.0);
        EXPECT_LT(std::max({std::acos(a.dot(b)), std::acos(b.dot(c)), std::acos(c.dot(a))}), 0.2701);
    }
    for (const Vec3& direction : cap.directions) {
        EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
    }
}

TEST(DirectionCap, TheCapOfASaddleHasANegativeArea) {
    // The loop runs the other way round, as at a vertex with more than 2 pi around it.
    const auto loop = loop_through({Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()}, 4);
    EXPECT_NEAR(area(cap_over(loop, Vec3(1, 1, 1), -M_PI / 2.0, 0.5)), -M_PI / 2.0, 1e-12);
}

TEST(DirectionCap, ALuneThatIsHalfACircleWideEnds) {
    // A thin fin: half the equator, and back over a pole. The mean of its normals is nowhere amid it.
    std::vector<Vec3> loop = loop_through({Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitX(), -Vec3::UnitZ()}, 6);
    const DirectionCap cap = cap_over(loop, Vec3::Zero(), M_PI, 0.65);
    EXPECT_NEAR(std::abs(area(cap)), M_PI, 1e-9);
    EXPECT_LT(cap.triangles.size(), 300U);
}

TEST(DirectionCap, AnArcBetweenOppositeDirectionsHasUnitLength) {
    for (const double fraction : {0.0, 0.3, 0.5, 0.9}) {
        EXPECT_NEAR(on_arc(Vec3::UnitZ(), -Vec3::UnitZ(), fraction).norm(), 1.0, 1e-12);
    }
    EXPECT_NEAR(on_arc(Vec3::UnitZ(), -Vec3::UnitZ(), 0.5).dot(Vec3::UnitZ()), 0.0, 1e-12);
}

}  // namespace
}  // namespace mq::offset
