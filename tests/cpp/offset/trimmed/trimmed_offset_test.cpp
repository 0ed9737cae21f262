// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/trimmed/trimmed_offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "base/error.h"
#include "boolean/closed_solids.h"
#include "mesh/quality/surface_verification.h"
#include "offset/offset_checks.h"

namespace mq::offset {

namespace solids = boolean::solids;

using boolean::Operation;

namespace {

using checks::united;
using checks::volume;
using mesh::Triangle;
using mesh::TriangleMesh;

OffsetResult sound_offset(const TriangleMesh& solid, double distance, double tolerance) {
    Progress progress;
    return checks::sound(offset(solid, {distance, tolerance, 0}, progress), tolerance);
}

TEST(Offset, ABoxGrowsRoundEdgesAndShrinksToABox) {
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const double grown = 1000 + 1200 + 30 * M_PI * 4 + 4.0 / 3.0 * M_PI * 8;
    EXPECT_NEAR(volume(sound_offset(box, 2.0, 0.02).mesh) / grown, 1.0, 2e-3);
    const OffsetResult shrunk = sound_offset(box, -2.0, 0.02);
    EXPECT_EQ(shrunk.mesh.triangles.size(), 12U);
    EXPECT_NEAR(volume(shrunk.mesh), 216.0, 0.1);
}

TEST(Offset, ASmoothSurfaceKeepsItsConnectivity) {
    const TriangleMesh ball = solids::sphere(Vec3(1, 2, 3), 5.0, 40);
    const OffsetResult result = sound_offset(ball, 0.5, 0.02);
    EXPECT_EQ(result.mesh.triangles.size(), ball.triangles.size());
    EXPECT_EQ(result.crossing_pairs, 0U);
}

TEST(Offset, NothingIsLeftOfWhatIsThinnerThanTwiceTheDistance) {
    const TriangleMesh plate = solids::box(Vec3(0, 0, 0), Vec3(20, 20, 2));
    EXPECT_TRUE(sound_offset(plate, -1.1, 0.02).mesh.triangles.empty());
    EXPECT_FALSE(sound_offset(plate, -0.9, 0.02).mesh.triangles.empty());
}

TEST(Offset, ARingOfWhichTheHoleClosesIsFilled) {
    // Around a point on the axis the ball meets the ring in a ring: the Euler characteristic is 0, and the raw offset
    // does not wind around it.
    const TriangleMesh outer = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 4));
    const TriangleMesh hole = solids::box(Vec3(4, 4, -1), Vec3(6, 6, 5));
    const TriangleMesh ring = united({&outer, &hole}, Operation::Difference);
    const TriangleMesh closed = sound_offset(ring, 1.2, 0.02).mesh;
    const TriangleMesh solid = sound_offset(outer, 1.2, 0.02).mesh;
    // Dimples are left at both ends of the hole.
    EXPECT_LT(volume(closed), volume(solid));
    EXPECT_GT(volume(closed), volume(solid) - 2.0 * 4.0 * 1.2);
}

TEST(Offset, AGapOfTwiceTheDistanceCloses) {
    const TriangleMesh left = solids::box(Vec3(0, 0, 0), Vec3(4, 10, 10));
    const TriangleMesh right = solids::box(Vec3(6, 0, 0), Vec3(10, 10, 10));
    const TriangleMesh foot = solids::box(Vec3(0, 0, -2), Vec3(10, 10, 1));
    sound_offset(united({&left, &right, &foot}), 1.0, 0.02);
}

TEST(Offset, RandomUnionsOfBoxesAndBallsAreSoundOrSayWhatTheyMiss) {
    std::mt19937 random(7);
    const auto number = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    int within = 0;
    constexpr int kRounds = 12;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<TriangleMesh> bodies;
        for (int i = 0; i < 3; ++i) {
            const Vec3 low(number(0, 8), number(0, 8), number(0, 8));
            const Vec3 size(number(1, 6), number(1, 6), number(1, 6));
            bodies.push_back(i % 2 == 0 ? solids::box(low, low + size) : solids::sphere(low, size.x(), 10));
        }
        const TriangleMesh solid = united({&bodies[0], &bodies[1], &bodies[2]});
        const double here = volume(solid);
        for (const double distance : {0.4, -0.4}) {
            Progress progress;
            try {
                const OffsetResult result = offset(solid, {distance, 0.02, 0}, progress);
                EXPECT_TRUE(mesh::verify(result.mesh.vertices, result.mesh.triangles).passed());
                if (result.error_bound <= 0.02) {
                    ++within;
                    EXPECT_GT((volume(result.mesh) - here) * distance, 0.0);
                }
            } catch (const TopologyError& error) {
                EXPECT_NE(std::string(error.what()).find("choose"), std::string::npos);  // a remedy
            }
        }
    }
    EXPECT_GE(within, 2 * kRounds - 4);
}

TEST(Offset, TheSameForAnyNumberOfThreads) {
    const TriangleMesh a = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const TriangleMesh b = solids::sphere(Vec3(10, 10, 10), 4.0, 12);
    const TriangleMesh solid = united({&a, &b}, Operation::Difference);
    Progress progress;
    const OffsetResult one = offset(solid, {0.7, 0.02, 1}, progress);
    const OffsetResult five = offset(solid, {0.7, 0.02, 5}, progress);
    EXPECT_EQ(one.mesh.vertices, five.mesh.vertices);
    EXPECT_EQ(one.mesh.triangles, five.mesh.triangles);
    EXPECT_EQ(one.error_bound, five.error_bound);
}

TEST(Thicken, WallsOfABoxWithoutItsTop) {
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    std::vector<char> open;
    for (const Triangle& t : box.triangles) {
        open.push_back(std::all_of(t.begin(), t.end(), [](int v) { return v >= 4; }) ? 1 : 0);
    }
    Progress progress;
    const OffsetResult walls = thicken(box, open, {1.0, 0.02, 0}, progress);
    EXPECT_LE(walls.error_bound, 0.02);
    EXPECT_NEAR(volume(united({&box, &walls.mesh}, Operation::Intersection)), 1000.0 - 8 * 8 * 9, 0.5);
}

TEST(Offset, IsGivenUpWhereDividingWouldTakeTooLong) {
    // Inward of a slender cone all of its sides cross each other behind the apex.
    const int sides = 600;
    TriangleMesh cone;
    cone.vertices = {Vec3(0, 0, 30), Vec3(0, 0, 0)};
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * M_PI * i / sides;
        cone.vertices.emplace_back(5.0 * std::cos(angle), 5.0 * std::sin(angle), 0.0);
        const Triangle::value_type a = 2 + i, b = 2 + (i + 1) % sides;
        cone.triangles.push_back({0, a, b});
        cone.triangles.push_back({1, b, a});
    }
    Progress progress;
    try {
        offset(cone, {-1.0, 1e-3, 0}, progress);
        FAIL() << "it was divided";
    } catch (const TopologyError& error) {
        EXPECT_NE(std::string(error.what()).find("too many to divide"), std::string::npos) << error.what();
    }
}

TEST(Offset, OptionsAreChecked) {
    const TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    Progress progress;
    EXPECT_THROW(offset(box, {0.0, 0.1, 0}, progress), InvalidInput);
    EXPECT_THROW(offset(box, {1.0, 0.0, 0}, progress), InvalidInput);
    EXPECT_THROW(offset(box, {1.0, 2.0, 0}, progress), InvalidInput);
    EXPECT_THROW(offset(box, {std::nan(""), 0.1, 0}, progress), InvalidInput);
    EXPECT_THROW(thicken(box, std::vector<char>(12, 1), {1.0, 0.1, 0}, progress), InvalidInput);
    progress.cancel();
    EXPECT_THROW(offset(box, {0.1, 0.01, 0}, progress), Cancelled);
}

}  // namespace
}  // namespace mq::offset
