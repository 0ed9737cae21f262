// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <thread>

#include "base/error.h"
#include "base/parallel.h"
#include "inspection/solids.h"

namespace mq::inspection {
namespace {

Thickness measured(const mesh::TriangleMesh& mesh, double spacing = 0.0, bool outside = false) {
    ThicknessOptions options;
    options.spacing = spacing;
    options.outside = outside;
    return thickness(mesh, {}, options);
}

double least(const ThicknessValues& values) {
    double found = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < values.value.size(); ++k) {
        found = values.is_wall[k] != 0 ? std::min(found, values.value[k]) : found;
    }
    return found;
}

/// All walls whose point `takes` have the thickness that is expected there, within a fraction of it.
void expect_walls(const ThicknessValues& values, const std::function<bool(const Vec3&)>& takes,
                  const std::function<double(const Vec3&)>& expected, double within) {
    std::size_t found = 0;
    for (std::size_t k = 0; k < values.value.size(); ++k) {
        if (values.is_wall[k] != 0 && takes(values.point[k])) {
            EXPECT_NEAR(values.value[k] / expected(values.point[k]), 1.0, within) << values.point[k].transpose();
            ++found;
        }
    }
    EXPECT_GT(found, 0u);
}

bool everywhere(const Vec3&) {
    return true;
}

TEST(Thickness, OfPlates) {
    for (const double wall : {0.8, 3.0}) {
        const Thickness found = measured(solids::box(Vec3(0, 0, 0), Vec3(60, 40, wall)));
        EXPECT_NEAR(least(found.rays), wall, 1e-12);
        EXPECT_NEAR(least(found.balls), wall, 1e-9);
        // Small sides measure across the plate by rays, and are corners for balls.
        const auto is_large = [&](const Vec3& p) { return p.z() == 0.0 || p.z() == wall; };
        expect_walls(
            found.rays, is_large, [&](const Vec3&) { return wall; }, 1e-12);
        expect_walls(
            found.balls, everywhere, [&](const Vec3&) { return wall; }, 1e-9);
    }
}

TEST(Thickness, OfPipes) {
    for (const double wall : {0.8, 3.0}) {
        for (const int sides : {48, 96, 192}) {
            const double chord_height = 10.0 * (1.0 - std::cos(M_PI / sides));
            const Thickness found = measured(solids::pipe(10.0 - wall, 10.0, 20.0, sides), 1e3);
            const auto is_side = [](const Vec3& p) { return p.z() > 3.0 && p.z() < 17.0; };
            const double within = 2.0 * chord_height / wall;
            expect_walls(
                found.rays, is_side, [&](const Vec3&) { return wall; }, within);
            expect_walls(
                found.balls, is_side, [&](const Vec3&) { return wall; }, within);
            EXPECT_NEAR(least(found.balls), wall, 2.0 * chord_height);
        }
    }
}

TEST(Thickness, OfSolidBarsAndBallsIsTheirDiameter) {
    for (const int sides : {24, 48, 96}) {
        const Thickness found = measured(solids::pipe(0.0, 5.0, 30.0, sides), 1e3);
        const auto is_side = [](const Vec3& p) { return p.z() > 6.0 && p.z() < 24.0; };
        const double within = 2.0 * (1.0 - std::cos(M_PI / sides));
        expect_walls(
            found.rays, is_side, [](const Vec3&) { return 10.0; }, within);
        expect_walls(
            found.balls, is_side, [](const Vec3&) { return 10.0; }, within);
    }
    const Thickness ball = measured(solids::sphere(5.0, 4), 1e3);
    expect_walls(
        ball.rays, everywhere, [](const Vec3&) { return 10.0; }, 0.01);
    expect_walls(
        ball.balls, everywhere, [](const Vec3&) { return 10.0; }, 0.01);
    EXPECT_EQ(std::count(ball.balls.is_wall.begin(), ball.balls.is_wall.end(), 0), 0);
}

TEST(Thickness, OfASphereShellWhoseCentresDiffer) {
    // The cavity lies 0.7 off the centre: the wall is 1.3 on one side and 2.7 on the other.
    mesh::TriangleMesh mesh = solids::sphere(10.0, 5);
    solids::add(mesh, solids::sphere(8.0, 5, Vec3(0.7, 0, 0)), true);
    const Thickness found = measured(mesh, 1e3);
    EXPECT_NEAR(least(found.rays), 1.3, 0.026);
    EXPECT_NEAR(least(found.balls), 1.3, 0.026);
    // A ball of diameter d that touches the outer sphere at p has its centre at (10 - d / 2) of p's direction, 8 + d /
    // 2 from the cavity's centre.
    const auto exact = [](const Vec3& p) {
        const double c = p.normalized().x();
        return 2.0 * (100.0 + 0.49 - 14.0 * c - 64.0) / (36.0 - 1.4 * c);
    };
    const auto is_outer = [](const Vec3& p) { return p.norm() > 9.9; };
    expect_walls(found.balls, is_outer, exact, 0.02);
}

TEST(Thickness, OfATaperedWall) {
    // From 0.8 to 3 mm over 40 mm, with the plane z = 0 below.
    const double slope = 2.2 / 40.0;
    const double angle = std::atan(slope);
    const double apex = -0.8 / slope;
    const mesh::TriangleMesh mesh =
        solids::hexahedron({Vec3(0, 0, 0), Vec3(40, 0, 0), Vec3(0, 30, 0), Vec3(40, 30, 0), Vec3(0, 0, 0.8),
                            Vec3(40, 0, 3.0), Vec3(0, 30, 0.8), Vec3(40, 30, 3.0)});
    const Thickness found = measured(mesh, 1.0);
    const auto is_below = [](const Vec3& p) { return p.z() == 0.0; };
    expect_walls(
        found.rays, is_below, [&](const Vec3& p) { return 0.8 + slope * p.x(); }, 1e-9);
    expect_walls(
        found.balls, is_below, [&](const Vec3& p) { return 2.0 * (p.x() - apex) * std::tan(0.5 * angle); }, 1e-8);
    EXPECT_NEAR(least(found.balls), 0.8, 0.016 + slope);
}

TEST(Thickness, CornersAreNoWallsAndKnifeEdgesAre) {
    const Thickness cube = measured(solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10)));
    // Balls are limited by the nearest edge, but for one in the middle of each side.
    EXPECT_EQ(least(cube.balls), std::numeric_limits<double>::infinity());
    EXPECT_NEAR(least(cube.rays), 10.0, 1e-12);
    // A wedge of 30 degrees gets thinner than any bound.
    const double height = 20.0 * std::tan(M_PI / 6.0);
    mesh::TriangleMesh wedge;
    wedge.vertices = {Vec3(0, 0, 0),  Vec3(20, 0, 0),  Vec3(20, 0, height),
                      Vec3(0, 20, 0), Vec3(20, 20, 0), Vec3(20, 20, height)};
    wedge.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 4, 1}, {0, 3, 4}, {1, 4, 5}, {1, 5, 2}, {0, 2, 5}, {0, 5, 3}};
    const Thickness found = measured(wedge, 0.5);
    EXPECT_LT(least(found.balls), 0.2);
    EXPECT_LT(least(found.rays), 0.2);
}

TEST(Thickness, OutsideIsTheWidthOfASlot) {
    // A comb of two blocks on a base, 1.5 mm apart; joined as one body by overlap.
    mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(20, 10, 3));
    solids::add(mesh, solids::box(Vec3(2, 1, 2), Vec3(8, 9, 12)));
    solids::add(mesh, solids::box(Vec3(9.5, 1, 2), Vec3(16, 9, 12)));
    const Thickness found = measured(mesh, 0.5, true);
    EXPECT_NEAR(least(found.rays), 1.5, 1e-9);
    EXPECT_NEAR(least(found.balls), 1.5, 1e-9);
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        if (found.rays.is_wall[k] == 0) {
            EXPECT_FALSE(found.rays.value[k] < 1.4);
        }
    }
}

TEST(Thickness, OfBodiesThatOverlapEndsWhereBothDo) {
    mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 2));
    solids::add(mesh, solids::box(Vec3(0.5, 0.5, 1), Vec3(9.5, 9.5, 5)));
    ThicknessOptions options;
    options.spacing = 1e3;
    const Thickness one = thickness(mesh, {}, options);
    // The bottom: through both.
    EXPECT_NEAR(one.rays.value[0], 5.0, 1e-12);
    // The bottom of the second lies inside of the first.
    EXPECT_TRUE(std::isnan(one.rays.value[12]));
    EXPECT_TRUE(std::isnan(one.balls.value[12]));
    std::vector<std::int32_t> body(mesh.triangles.size(), 0);
    std::fill(body.begin() + 12, body.end(), 1);
    const Thickness two = thickness(mesh, body, options);
    EXPECT_NEAR(two.rays.value[0], 2.0, 1e-12);
    EXPECT_NEAR(two.rays.value[12], 4.0, 1e-12);
}

TEST(Thickness, IsTheSameForAnyNumberOfThreads) {
    const mesh::TriangleMesh mesh = solids::pipe(8.0, 10.0, 20.0, 60);
    Thickness before;
    for (const int threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        const Thickness found = measured(mesh);
        if (threads > 1) {
            EXPECT_EQ(found.rays.value, before.rays.value);
            EXPECT_EQ(found.balls.value, before.balls.value);
            EXPECT_EQ(found.balls.point, before.balls.point);
            EXPECT_EQ(found.balls.opposite, before.balls.opposite);
            EXPECT_EQ(found.balls.is_wall, before.balls.is_wall);
        }
        before = found;
    }
}

TEST(Thickness, CanBeCancelled) {
    const mesh::TriangleMesh mesh = solids::sphere(5.0, 7);
    Progress progress;
    ThicknessOptions options;
    options.spacing = 0.01;
    std::chrono::steady_clock::time_point asked;
    std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        asked = std::chrono::steady_clock::now();
        progress.cancel();
    });
    EXPECT_THROW(thickness(mesh, {}, options, &progress), Cancelled);
    const auto ended = std::chrono::steady_clock::now();
    canceller.join();
    EXPECT_LT(std::chrono::duration<double>(ended - asked).count(), 0.2);
}

TEST(Thickness, RefusesOptionsOutOfRange) {
    const mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    ThicknessOptions options;
    options.corner_angle = 90.0;
    EXPECT_THROW(thickness(mesh, {}, options), InvalidInput);
    options.corner_angle = 45.0;
    options.spacing = -1.0;
    EXPECT_THROW(thickness(mesh, {}, options), InvalidInput);
}

}  // namespace
}  // namespace mq::inspection
