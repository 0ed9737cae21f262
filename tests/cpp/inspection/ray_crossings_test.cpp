// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/ray_crossings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "inspection/solids.h"

namespace mq::inspection {
namespace {

std::vector<Crossing> shoot(const mesh::TriangleMesh& mesh, const Vec3& origin, const Vec3& direction,
                            std::int32_t own = -1) {
    const mesh::AabbTree tree(mesh.vertices, mesh.triangles);
    return crossings_of(tree, mesh.vertices, mesh.triangles, origin, direction, own);
}

TEST(RayCrossings, AreInTheirOrderAndSayWhereTheSolidIsLeft) {
    mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    solids::add(mesh, solids::box(Vec3(4, 4, 4), Vec3(6, 6, 6)), true);
    const std::vector<Crossing> found = shoot(mesh, Vec3(-1.0, 5.1, 5.3), Vec3(1, 0, 0));
    ASSERT_EQ(found.size(), 4u);
    const double expected[] = {1.0, 5.0, 7.0, 11.0};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(found[i].distance, expected[i], 1e-12);
        EXPECT_EQ(found[i].leaves, i % 2 == 1);
    }
    EXPECT_EQ(winding_at_start(found), 0);
}

TEST(RayCrossings, ThroughEdgesAndCornersCountOnce) {
    const mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(2, 2, 2));
    // Through diagonals of faces, along faces, through edges and corners; origins inside, outside and on planes.
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(-1, 1, 1),
                                  Vec3(1, -1, 0), Vec3(0, 1, 1), Vec3(2, 1, 0), Vec3(2, 1, 1)}) {
        for (const Vec3& from : {Vec3(1, 1, 1), Vec3(0.5, 0.5, 0.5), Vec3(1, 0.5, 1.5)}) {
            const std::vector<Crossing> found = shoot(mesh, from, direction.normalized());
            EXPECT_EQ(winding_at_start(found), 1) << direction.transpose() << " from " << from.transpose();
        }
        for (const Vec3& from : {Vec3(-1, -1, -1), Vec3(-2, 0, 0), Vec3(3, 1, 1), Vec3(-1, 2, 2), Vec3(0, -3, 2)}) {
            const std::vector<Crossing> found = shoot(mesh, from, direction.normalized());
            EXPECT_EQ(winding_at_start(found), 0) << direction.transpose() << " from " << from.transpose();
        }
    }
}

TEST(RayCrossings, OfARoundSolidAreEvenThroughEachVertex) {
    const mesh::TriangleMesh mesh = solids::sphere(3.0, 3);
    const mesh::AabbTree tree(mesh.vertices, mesh.triangles);
    for (const Vec3& vertex : mesh.vertices) {
        const std::vector<Crossing> found =
            crossings_of(tree, mesh.vertices, mesh.triangles, Vec3(0, 0, 0), vertex.normalized(), -1);
        ASSERT_EQ(winding_at_start(found), 1);
        EXPECT_NEAR(found.front().distance, 3.0, 1e-12);
    }
}

TEST(RayCrossings, LeaveOutTheTriangleWhereTheyStart) {
    const mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(3, 3, 3));
    const mesh::Triangle& t = mesh.triangles[0];  // in the plane z = 0
    const Vec3 start = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    const std::vector<Crossing> inward = shoot(mesh, start, Vec3(0, 0, 1), 0);
    ASSERT_EQ(inward.size(), 1u);
    EXPECT_DOUBLE_EQ(inward[0].distance, 3.0);
    EXPECT_TRUE(shoot(mesh, start, Vec3(0, 0, -1), 0).empty());
}

}  // namespace
}  // namespace mq::inspection
