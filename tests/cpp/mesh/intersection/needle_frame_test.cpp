// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/needle_frame.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "mesh/intersection/aabb_tree.h"

namespace mq::mesh {
namespace {

/// A turned rectangle of 2 x 1, cut into `count` strips of two triangles each.
void strips(int count, std::vector<Vec3>& vertices, std::vector<Triangle>& triangles) {
    const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
    for (int i = 0; i <= count; ++i) {
        const double y = double(i) / count;
        vertices.emplace_back(turn * Vec3(0, y, 0));
        vertices.emplace_back(turn * Vec3(2, y, 0));
    }
    for (int i = 0; i < count; ++i) {
        triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
        triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
    }
}

std::size_t pairs(const AabbTree& tree) {
    std::size_t count = 0;
    tree.for_each_own_pair([&](std::int32_t, std::int32_t) { ++count; });
    return count;
}

TEST(NeedleFrame, BoxesOfNeedlesMeetTheirNeighboursOnly) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    strips(500, vertices, triangles);
    const NeedleFrame frame(vertices, triangles);
    EXPECT_GT(frame.slack(), 0.0);
    EXPECT_LT(frame.slack(), 1e-13);
    EXPECT_LT(pairs(AabbTree(frame.vertices(), triangles, frame.slack())), 4000u);
    EXPECT_GT(pairs(AabbTree(vertices, triangles)), 100000u);
}

TEST(NeedleFrame, ItIsATurn) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    strips(60, vertices, triangles);
    const NeedleFrame frame(vertices, triangles);
    for (std::size_t v = 1; v < vertices.size(); ++v) {
        EXPECT_NEAR((frame.vertices()[v] - frame.vertices()[0]).norm(), (vertices[v] - vertices[0]).norm(), 1e-14);
    }
}

TEST(NeedleFrame, AMeshWithoutNeedlesKeepsItsCoordinates) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<Triangle> triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const NeedleFrame frame(vertices, triangles);
    EXPECT_EQ(frame.slack(), 0.0);
    EXPECT_EQ(&frame.vertices(), &vertices);
}

}  // namespace
}  // namespace mq::mesh
