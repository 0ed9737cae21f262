// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/largest_ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "inspection/solids.h"

namespace mq::inspection {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(LargestBall, TouchesTheOtherSideOfAPlate) {
    const mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(20, 20, 3));
    const mesh::NearestTree tree(mesh.vertices, mesh.triangles);
    FreeBalls known;
    const LargestBall ball = largest_ball(tree, Vec3(9, 10, 0), Vec3(0, 0, 1), 0.0, 3.0, 2, known);
    EXPECT_DOUBLE_EQ(ball.radius, 1.5);
    EXPECT_EQ(opposite_contact(tree, mesh.vertices, mesh.triangles, ball, Vec3(0, 0, 1), M_PI / 4.0).triangle, 2);
}

TEST(LargestBall, ShrinksToTheNearerSideAtACorner) {
    const mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(20, 20, 3));
    const mesh::NearestTree tree(mesh.vertices, mesh.triangles);
    FreeBalls known;
    const LargestBall ball = largest_ball(tree, Vec3(0.4, 10, 0), Vec3(0, 0, 1), 0.0, 3.0, 2, known);
    EXPECT_NEAR(ball.radius, 0.4, 1e-9);
    EXPECT_NEAR(ball.contact.x(), 0.0, 1e-9);
    EXPECT_EQ(opposite_contact(tree, mesh.vertices, mesh.triangles, ball, Vec3(0, 0, 1), M_PI / 4.0).triangle, -1);
}

TEST(LargestBall, IsInfiniteOutsideOfAConvexSolid) {
    const mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(20, 20, 3));
    const mesh::NearestTree tree(mesh.vertices, mesh.triangles);
    FreeBalls known;
    const LargestBall ball = largest_ball(tree, Vec3(9, 10, 0), Vec3(0, 0, -1), 0.0, kInfinite, -1, known);
    EXPECT_EQ(ball.radius, kInfinite);
    EXPECT_EQ(ball.triangle, -1);
}

TEST(LargestBall, FitsAndIsTheLargest) {
    mesh::TriangleMesh mesh = solids::sphere(5.0, 3);
    solids::add(mesh, solids::sphere(1.0, 3, Vec3(1.5, 0.5, 0.2)), true);
    const mesh::NearestTree tree(mesh.vertices, mesh.triangles);
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 200; ++i) {
        // Balls that start at a point of the inside do the same as at one of the surface.
        const Vec3 start = -2.0 * Vec3(1, 1, 1) + 0.2 * Vec3(normal(random), normal(random), normal(random));
        const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
        FreeBalls known;
        const LargestBall ball = largest_ball(tree, start, direction, 0.0, kInfinite, -1, known);
        ASSERT_GE(ball.triangle, 0);
        EXPECT_GE(tree.nearest(ball.center).distance, ball.radius * (1.0 - 1e-9));
        const double more = ball.radius * 1.001;
        EXPECT_LT(tree.nearest(start + more * direction).distance, more * (1.0 - 1e-9));
    }
}

}  // namespace
}  // namespace mq::inspection
