// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/edge_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mq::contour {
namespace {

/// Two poles (0 and 1) over a ring of vertices (from 2 on).
std::vector<mesh::Triangle> double_cone(std::int32_t around) {
    std::vector<mesh::Triangle> triangles;
    for (std::int32_t k = 0; k < around; ++k) {
        const std::int32_t next = 2 + (k + 1) % around;
        triangles.push_back({0, 2 + k, next});
        triangles.push_back({1, next, 2 + k});
    }
    return triangles;
}

std::size_t triangles_at(const EdgeMesh& mesh, std::int32_t v) {
    std::size_t count = 0;
    for ([[maybe_unused]] const std::int32_t corner : mesh.corners_at(v)) {
        ++count;
    }
    return count;
}

TEST(EdgeMesh, TrianglesShareTheirEdges) {
    std::vector<mesh::Triangle> triangles = double_cone(5);
    const EdgeMesh mesh(triangles, 7);
    EXPECT_EQ(mesh.edge_count(), 15U);
    for (std::int32_t t = 0; t < 10; ++t) {
        for (int k = 0; k < 3; ++k) {
            const std::int32_t beyond = mesh.corner_of(triangles[t][(k + 1) % 3], triangles[t][k]);
            ASSERT_GE(beyond, 0);
            EXPECT_EQ(mesh.edge_after(beyond / 3, beyond % 3), mesh.edge_after(t, k));
        }
    }
    EXPECT_EQ(mesh.corner_of(0, 1), -1);
}

TEST(EdgeMesh, ACollapseLeavesAClosedSurface) {
    std::vector<mesh::Triangle> triangles = double_cone(5);
    EdgeMesh mesh(triangles, 7);
    ASSERT_TRUE(mesh.keeps_links(2, 3));
    const EdgeMesh::Merged& merged = mesh.merge(2, 3);
    EXPECT_EQ(merged.edges.size(), 2U);
    std::vector<std::int32_t> vertices = merged.vertices;
    std::sort(vertices.begin(), vertices.end());
    EXPECT_EQ(vertices, (std::vector<std::int32_t>{0, 1}));
    EXPECT_EQ(triangles_at(mesh, 3), 0U);
    EXPECT_EQ(triangles_at(mesh, 0), 4U);
    EXPECT_EQ(std::count(triangles.begin(), triangles.end(), mesh::Triangle{-1, -1, -1}), 2);
    for (std::int32_t t = 0; t < 10; ++t) {
        for (int k = 0; k < 3 && triangles[t][0] >= 0; ++k) {
            const std::int32_t a = triangles[t][k];
            const std::int32_t b = triangles[t][(k + 1) % 3];
            const std::int32_t beyond = mesh.corner_of(b, a);
            ASSERT_GE(beyond, 0);
            EXPECT_EQ(mesh.edge_after(beyond / 3, beyond % 3), mesh.edge_after(t, k));
            std::array<std::int32_t, 2> ends = mesh.ends(mesh.edge_after(t, k));
            std::sort(ends.begin(), ends.end());
            EXPECT_EQ(ends, (std::array<std::int32_t, 2>{std::min(a, b), std::max(a, b)}));
        }
    }
}

TEST(EdgeMesh, CollapsesThatPinchOrEndTheSurfaceAreRefused) {
    // The poles of a double cone over a triangle are joined by none of its edges, but each ring edge is beside both.
    std::vector<mesh::Triangle> pinched = double_cone(3);
    EdgeMesh mesh(pinched, 5);
    EXPECT_TRUE(mesh.keeps_links(0, 2));
    EXPECT_FALSE(mesh.keeps_links(2, 3));
    std::vector<mesh::Triangle> tetrahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    EXPECT_FALSE(EdgeMesh(tetrahedron, 4).keeps_links(0, 1));
}

}  // namespace
}  // namespace mq::contour
