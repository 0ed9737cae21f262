// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/export_mesh.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

using samples::tetrahedron;

Patches two_patches() {
    Patches patches;
    patches.groups = {{"inlet"}, {"walls"}};
    patches.of_triangle = {1, 0, 1, 1};
    patches.given = true;
    return patches;
}

TEST(ExportMesh, WithoutPatchesAllTrianglesAreOne) {
    const ExportMesh mesh = exported(tetrahedron());
    ASSERT_EQ(mesh.patches().size(), 1u);
    EXPECT_EQ(mesh.patches()[0].name, "Surface");
    EXPECT_EQ(mesh.triangles().size(), 4u);
    EXPECT_FALSE(mesh.patches_given);
}

TEST(ExportMesh, PointsHaveOriginAndScale) {
    TriangleMesh far = tetrahedron();
    far.origin = Vec3(1000, 0, 0);
    const ExportMesh mesh = exported(far, {}, 0.001);
    EXPECT_EQ(mesh.point(1), Vec3(1001.0 * 0.001, 0, 0));
}

TEST(ExportMesh, ElementsAndNodesByPatch) {
    const ExportMesh mesh = exported(tetrahedron(), two_patches());
    const auto triangles = mesh.triangles().by_group(2);
    EXPECT_EQ(triangles[0], (std::vector<std::int32_t>{1}));
    EXPECT_EQ(triangles[1], (std::vector<std::int32_t>{0, 2, 3}));
    const auto nodes = mesh.nodes_by_patch();
    EXPECT_EQ(nodes[0].size(), 3u);
    EXPECT_EQ(nodes[1], (std::vector<std::int32_t>{0, 1, 2, 3}));
}

TEST(ExportMesh, PatchesThatDoNotFitAreRefused) {
    Patches patches = two_patches();
    patches.of_triangle.pop_back();
    EXPECT_THROW(exported(tetrahedron(), patches), InvalidInput);
    patches = two_patches();
    patches.of_triangle[2] = 2;
    EXPECT_THROW(exported(tetrahedron(), patches), InvalidInput);
    patches.of_triangle[2] = -1;
    EXPECT_THROW(exported(tetrahedron(), patches), InvalidInput);
}

}  // namespace
}  // namespace mq::mesh
