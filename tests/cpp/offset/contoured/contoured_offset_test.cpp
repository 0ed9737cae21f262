// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/contoured/contoured_offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.h"
#include "boolean/closed_solids.h"
#include "offset/offset_checks.h"

namespace mq::offset {

namespace {

using boolean::Operation;
using checks::united;
using checks::volume;
using mesh::Triangle;
using mesh::TriangleMesh;

OffsetResult sound_offset(const TriangleMesh& solid, double distance, double tolerance) {
    Progress progress;
    return checks::sound(contoured_offset(solid, {distance, tolerance, 0}, progress), tolerance);
}

TEST(ContouredOffset, ABoxGrowsRoundEdgesAndShrinksToABox) {
    const TriangleMesh box = boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const double grown = 1000 + 1200 + 30 * M_PI * 4 + 4.0 / 3.0 * M_PI * 8;
    EXPECT_NEAR(volume(sound_offset(box, 2.0, 0.02).mesh) / grown, 1.0, 2e-3);
    const OffsetResult shrunk = sound_offset(box, -2.0, 0.02);
    EXPECT_LE(shrunk.mesh.triangles.size(), 100U);  // its faces are flat, its edges sharp
    EXPECT_NEAR(volume(shrunk.mesh), 216.0, 0.1);
}

TEST(ContouredOffset, ABallGrowsAndShrinksToBalls) {
    const TriangleMesh ball = boolean::solids::sphere(Vec3(1, 2, 3), 5.0, 40);
    for (const double distance : {0.5, -0.5}) {
        // The ball's facets are up to 0.02 within it.
        const double radius = 5.0 + distance;
        EXPECT_NEAR(volume(sound_offset(ball, distance, 0.02).mesh) / (4.0 / 3.0 * M_PI * radius * radius * radius),
                    1.0, 1.5e-2);
    }
}

TEST(ContouredOffset, TheBordersBetweenFacesAreKept) {
    TriangleMesh box = boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    for (const Triangle& t : box.triangles) {
        const Vec3 middle = (box.vertices[t[0]] + box.vertices[t[1]] + box.vertices[t[2]]) / 3.0;
        box.triangle_face.push_back(middle.z() > 9.9 ? 0 : 1);
    }
    const OffsetResult grown = sound_offset(box, 1.0, 0.02);
    double top = 0.0;
    for (std::size_t t = 0; t < grown.mesh.triangles.size(); ++t) {
        const auto corner = [&](std::size_t k) { return grown.mesh.vertices[grown.mesh.triangles[t][k]]; };
        if (box.triangle_face[grown.triangle_source[t]] == 0) {
            top += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
        }
    }
    // The face itself, quarters of cylinders along its edges, and eighths of balls at its corners.
    EXPECT_NEAR(top, 100.0 + 4 * 10 * M_PI / 2 + 4 * M_PI / 2, 2.0);
}

TEST(ContouredOffset, NothingIsLeftOfWhatIsThinnerThanTwiceTheDistance) {
    const TriangleMesh plate = boolean::solids::box(Vec3(0, 0, 0), Vec3(20, 20, 2));
    EXPECT_TRUE(sound_offset(plate, -1.1, 0.02).mesh.triangles.empty());
    EXPECT_FALSE(sound_offset(plate, -0.9, 0.02).mesh.triangles.empty());
}

TEST(ContouredOffset, ARingOfWhichTheHoleClosesIsFilled) {
    // Around a point on the axis the ball meets the ring in a ring.
    const TriangleMesh outer = boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 4));
    const TriangleMesh hole = boolean::solids::box(Vec3(4, 4, -1), Vec3(6, 6, 5));
    const TriangleMesh ring = united({&outer, &hole}, Operation::Difference);
    const TriangleMesh closed = sound_offset(ring, 1.2, 0.02).mesh;
    const TriangleMesh solid = sound_offset(outer, 1.2, 0.02).mesh;
    // Dimples are left at both ends of the hole.
    EXPECT_LT(volume(closed), volume(solid));
    EXPECT_GT(volume(closed), volume(solid) - 2.0 * 4.0 * 1.2);
}

TEST(ContouredOffset, AGapOfTwiceTheDistanceCloses) {
    const TriangleMesh left = boolean::solids::box(Vec3(0, 0, 0), Vec3(4, 10, 10));
    const TriangleMesh right = boolean::solids::box(Vec3(6, 0, 0), Vec3(10, 10, 10));
    const TriangleMesh foot = boolean::solids::box(Vec3(0, 0, -2), Vec3(10, 10, 1));
    sound_offset(united({&left, &right, &foot}), 1.0, 0.02);
}

TEST(ContouredOffset, RandomUnionsOfBoxesAndBallsAreSoundAndWithinTheTolerance) {
    std::mt19937 random(7);
    const auto number = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    constexpr int kRounds = 6;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<TriangleMesh> bodies;
        for (int i = 0; i < 3; ++i) {
            const Vec3 low(number(0, 8), number(0, 8), number(0, 8));
            const Vec3 size(number(1, 6), number(1, 6), number(1, 6));
            bodies.push_back(i % 2 == 0 ? boolean::solids::box(low, low + size)
                                        : boolean::solids::sphere(low, size.x(), 10));
        }
        const TriangleMesh solid = united({&bodies[0], &bodies[1], &bodies[2]});
        const double here = volume(solid);
        for (const double distance : {0.4, -0.4}) {
            EXPECT_GT((volume(sound_offset(solid, distance, 0.02).mesh) - here) * distance, 0.0);
        }
    }
}

TEST(ContouredOffset, TheSameForAnyNumberOfThreads) {
    const TriangleMesh a = boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const TriangleMesh b = boolean::solids::sphere(Vec3(10, 10, 10), 4.0, 12);
    const TriangleMesh solid = united({&a, &b}, Operation::Difference);
    Progress progress;
    const OffsetResult one = contoured_offset(solid, {0.7, 0.02, 1}, progress);
    const OffsetResult five = contoured_offset(solid, {0.7, 0.02, 5}, progress);
    EXPECT_EQ(one.mesh.vertices, five.mesh.vertices);
    EXPECT_EQ(one.mesh.triangles, five.mesh.triangles);
    EXPECT_EQ(one.error_bound, five.error_bound);
}

TEST(ContouredWalls, WallsOfABoxWithoutItsTop) {
    const TriangleMesh box = boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    std::vector<char> open;
    for (const Triangle& t : box.triangles) {
        open.push_back(std::all_of(t.begin(), t.end(), [](int v) { return v >= 4; }) ? 1 : 0);
    }
    Progress progress;
    const OffsetResult walls = contoured_walls(box, open, {1.0, 0.02, 0}, progress);
    EXPECT_LE(walls.error_bound, 0.02);
    EXPECT_NEAR(volume(united({&box, &walls.mesh}, Operation::Intersection)), 1000.0 - 8 * 8 * 9, 0.5);
}

TEST(ContouredOffset, OptionsAreChecked) {
    const TriangleMesh box = boolean::solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    Progress progress;
    EXPECT_THROW(contoured_offset(box, {0.0, 0.1, 0}, progress), InvalidInput);
    EXPECT_THROW(contoured_offset(box, {1.0, 0.0, 0}, progress), InvalidInput);
    EXPECT_THROW(contoured_offset(box, {1.0, 2.0, 0}, progress), InvalidInput);
    EXPECT_THROW(contoured_offset(box, {std::nan(""), 0.1, 0}, progress), InvalidInput);
    EXPECT_THROW(contoured_walls(box, std::vector<char>(12, 1), {1.0, 0.1, 0}, progress), InvalidInput);
    progress.cancel();
    EXPECT_THROW(contoured_offset(box, {0.1, 0.01, 0}, progress), Cancelled);
}

}  // namespace
}  // namespace mq::offset
