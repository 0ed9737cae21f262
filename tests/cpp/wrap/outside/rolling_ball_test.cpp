// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/outside/rolling_ball.h"

#include <gtest/gtest.h>

#include <cmath>

#include "wrap/boxes.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {
namespace {

constexpr double kSide = 0.25;

/// Marks what a ball of this diameter covers, and asks whether the node nearest to a point is outside.
bool is_outside(const mesh::TriangleMesh& mesh, double gap, const Vec3& p) {
    const InputSurface surface(mesh.vertices, mesh.triangles);
    const double radius = 0.5 * gap + 0.5 * kSide;
    const Lattice lattice(surface.tree.box(), radius + 2.0 * kSide, kSide);
    Progress progress;
    NodeStates states(lattice, surface, radius, progress);
    roll_ball(states, 0.5 * gap, progress);
    const Vec3 at = (p - lattice.at({0, 0, 0})) / (0.5 * kSide);
    Node node;
    for (std::size_t i = 0; i < 3; ++i) {
        node[i] = 2 * static_cast<std::int32_t>(std::lround(0.5 * at[static_cast<int>(i)]));
    }
    return states.is_outside(node);
}

mesh::TriangleMesh room_with_slot(double width) {
    mesh::TriangleMesh mesh;
    test::add_box(mesh, {0, 0, 0}, {8, 8, 8}, 1);
    test::add_box(mesh, {0, 0, 8}, {8, 8 - width, 9});
    return mesh;
}

TEST(RollingBall, EntersThroughWideOpeningsOnly) {
    EXPECT_FALSE(is_outside(room_with_slot(0.8), 1.0, {4, 4, 4}));
    // The gap and three sides of the lattice.
    EXPECT_TRUE(is_outside(room_with_slot(1.76), 1.0, {4, 4, 4}));
}

TEST(RollingBall, CoversConcaveEdgesToTheirEnds) {
    mesh::TriangleMesh mesh;
    test::add_box(mesh, {0, 0, 0}, {8, 8, 2});
    test::add_box(mesh, {0, 0, 2}, {2, 8, 8});
    EXPECT_TRUE(is_outside(mesh, 2.0, {2.2, 4, 2.2}));
    EXPECT_FALSE(is_outside(mesh, 2.0, {1.6, 4, 1.6}));
}

TEST(RollingBall, DeepSlotsStayClosed) {
    mesh::TriangleMesh mesh;
    test::add_box(mesh, {0, 0, 0}, {4, 8, 8});
    test::add_box(mesh, {5, 0, 0}, {9, 8, 8});
    EXPECT_FALSE(is_outside(mesh, 2.0, {4.5, 4, 4}));
}

}  // namespace
}  // namespace mq::wrap
