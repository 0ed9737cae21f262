// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/feature_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

using samples::tetrahedron;
using samples::torus;

std::ptrdiff_t count(const std::vector<bool>& in) {
    return std::count(in.begin(), in.end(), true);
}

TEST(FeatureEdges, AllEdgesOfATetrahedronAreSharp) {
    const FeatureEdges found = feature_edges(exported(tetrahedron()));
    EXPECT_EQ(found.edges.size(), 6u);
    EXPECT_EQ(count(found.sharp), 6);
    EXPECT_EQ(count(found.border), 0);
}

TEST(FeatureEdges, ASmoothSurfaceHasOnlyBordersOfPatches) {
    const TriangleMesh mesh = torus(48);
    EXPECT_TRUE(feature_edges(exported(mesh)).edges.empty());
    Patches patches;
    patches.groups = {{"one"}, {"rest"}};
    patches.of_triangle.assign(mesh.triangles.size(), 1);
    patches.of_triangle[5] = 0;
    const FeatureEdges found = feature_edges(exported(mesh, patches));
    ASSERT_EQ(found.edges.size(), 3u);
    EXPECT_EQ(count(found.border), 3);
    EXPECT_EQ(count(found.sharp), 0);
    for (const auto& edge : found.edges) {
        for (const std::int32_t node : edge) {
            const Triangle& t = mesh.triangles[5];
            EXPECT_NE(std::find(t.begin(), t.end(), node), t.end());
        }
    }
}

TEST(FeatureEdges, OpenEdgesAreSharp) {
    TriangleMesh mesh = torus(48);
    mesh.triangles.pop_back();
    mesh.triangle_face.clear();
    mesh.vertex_entity.clear();
    const FeatureEdges found = feature_edges(exported(mesh));
    EXPECT_EQ(found.edges.size(), 3u);
    EXPECT_EQ(count(found.sharp), 3);
}

TEST(FeatureEdges, TheAngleIsThatOfTheTurn) {
    const TriangleMesh mesh = torus(48);
    EXPECT_FALSE(feature_edges(exported(mesh), 0.5).edges.empty());
}

}  // namespace
}  // namespace mq::mesh
