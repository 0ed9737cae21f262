// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/clearance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "inspection/solids.h"

namespace mq::inspection {
namespace {

std::vector<Clearance> found_of(const std::vector<mesh::TriangleMesh>& meshes, double slack = 0.0,
                                const ClearanceOptions& options = {}) {
    std::vector<const mesh::TriangleMesh*> bodies;
    for (const mesh::TriangleMesh& mesh : meshes) {
        bodies.push_back(&mesh);
    }
    return clearances(bodies, std::vector<double>(meshes.size(), slack), options);
}

TEST(Clearance, OfBoxesFaceToFaceEdgeToEdgeAndCornerToCorner) {
    const std::vector<Clearance> found =
        found_of({solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10)), solids::box(Vec3(12, -5, 2), Vec3(15, 20, 8)),
                  solids::box(Vec3(13, 14, 11), Vec3(20, 20, 20)), solids::box(Vec3(-4, -4, -4), Vec3(-1, -2, -2))});
    ASSERT_EQ(found.size(), 6u);
    const double expected[] = {2.0, std::sqrt(9.0 + 16.0 + 1.0), 3.0, 3.0};
    EXPECT_NEAR(found[0].nearest.distance, expected[0], 1e-12);
    EXPECT_NEAR(found[1].nearest.distance, expected[1], 1e-12);
    EXPECT_LT((found[1].nearest.points[0] - Vec3(10, 10, 10)).norm(), 1e-12);
    EXPECT_LT((found[1].nearest.points[1] - Vec3(13, 14, 11)).norm(), 1e-12);
    EXPECT_NEAR(found[2].nearest.distance, 3.0, 1e-12);
    EXPECT_NEAR(found[3].nearest.distance, 3.0, 1e-12);
    for (const Clearance& one : found) {
        EXPECT_EQ(one.inside, -1);
        EXPECT_EQ(one.depth, 0.0);
    }
}

TEST(Clearance, OfRoundBodies) {
    const std::vector<Clearance> found = found_of(
        {solids::sphere(3.0, 4), solids::sphere(2.0, 4, Vec3(4, 3, 2)), solids::sphere(2.0, 4, Vec3(0, 0, 9))});
    EXPECT_NEAR(found[0].nearest.distance, std::sqrt(29.0) - 5.0, 0.02);
    EXPECT_NEAR(found[1].nearest.distance, 4.0, 1e-12);  // vertices lie on the poles
    const Vec3 between = found[0].nearest.points[1] - found[0].nearest.points[0];
    EXPECT_NEAR(between.norm(), found[0].nearest.distance, 1e-12);
}

TEST(Clearance, TellsTouchingCrossingAndInside) {
    mesh::TriangleMesh hollow = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    solids::add(hollow, solids::box(Vec3(2, 2, 2), Vec3(8, 8, 8)), true);
    const mesh::TriangleMesh full = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const mesh::TriangleMesh ball = solids::sphere(2.0, 3, Vec3(5, 5, 5));
    EXPECT_EQ(found_of({hollow, ball})[0].inside, -1);
    EXPECT_EQ(found_of({full, ball})[0].inside, 1);
    EXPECT_EQ(found_of({ball, full})[0].inside, 0);
    EXPECT_NEAR(found_of({full, ball})[0].nearest.distance, 3.0, 1e-12);
    const Clearance touching = found_of({full, solids::box(Vec3(2, 2, 10), Vec3(5, 5, 12))})[0];
    EXPECT_EQ(touching.nearest.distance, 0.0);
    EXPECT_EQ(touching.depth, 0.0);
    // Bars across each other, no corner of which lies in the other one.
    const Clearance crossing = found_of(
        {solids::box(Vec3(-9, -1, -1), Vec3(9, 1, 1)), solids::box(Vec3(-0.5, -9, -0.5), Vec3(0.5, 9, 0.5))})[0];
    EXPECT_EQ(crossing.nearest.distance, 0.0);
    EXPECT_NEAR(crossing.depth, 1.0, 1e-12);  // of a diagonal, amid the first
    const Clearance corner = found_of({full, solids::box(Vec3(9, 8, 9.5), Vec3(15, 15, 15))})[0];
    EXPECT_NEAR(corner.depth, 0.5, 1e-12);
}

TEST(Clearance, NamesAllPairsOfFacesThatAreAsNear) {
    mesh::TriangleMesh a = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    mesh::TriangleMesh b = solids::box(Vec3(11, 2, 2), Vec3(15, 8, 8));
    for (std::int32_t face = 0; face < 6; ++face) {
        a.triangle_face.insert(a.triangle_face.end(), 2, face);
        b.triangle_face.insert(b.triangle_face.end(), 2, face);
    }
    const Clearance near = found_of({a, b}, 0.1)[0];
    // The face of the first and the opposite one with the four around it.
    EXPECT_EQ(near.faces.size(), 5u);
    for (const NearestPlaces& places : near.faces) {
        EXPECT_LE(places.distance, near.nearest.distance + 0.2);
    }
}

TEST(Clearance, LeavesOutWhatIsFar) {
    ClearanceOptions options;
    options.within = 3.0;
    const std::vector<mesh::TriangleMesh> bodies{solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                                 solids::box(Vec3(3, 0, 0), Vec3(4, 1, 1)),
                                                 solids::box(Vec3(9, 0, 0), Vec3(10, 1, 1))};
    const std::vector<Clearance> found = found_of(bodies, 0.0, options);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].nearest.distance, 2.0, 1e-12);
}

TEST(Clearance, IsTheSameForAnyNumberOfThreadsAndCanBeCancelled) {
    const std::vector<mesh::TriangleMesh> bodies{solids::sphere(3.0, 5), solids::sphere(2.0, 5, Vec3(4, 3.1, 2))};
    std::vector<Clearance> before;
    for (const int threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        const std::vector<Clearance> found = found_of(bodies, 0.01);
        if (threads > 1) {
            EXPECT_EQ(found[0].nearest.triangles, before[0].nearest.triangles);
            EXPECT_EQ(found[0].nearest.distance, before[0].nearest.distance);
            EXPECT_EQ(found[0].nearest.points[1], before[0].nearest.points[1]);
        }
        before = found;
    }
    Progress progress;
    progress.cancel();
    EXPECT_THROW(clearances({&bodies[0], &bodies[1]}, {0.0, 0.0}, {}, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::inspection
