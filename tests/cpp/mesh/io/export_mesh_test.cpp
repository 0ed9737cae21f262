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
    const auto numbered = mesh.numbered(2);
    const auto patches = divided(mesh, numbered);
    ASSERT_EQ(patches.size(), 2u);
    EXPECT_EQ(patches[0].elements, (Members{"", {{&numbered[0], 1}}, {}}.elements));
    EXPECT_EQ(patches[1].elements,
              (Members{"", {{&numbered[0], 0}, {&numbered[0], 2}, {&numbered[0], 3}}, {}}.elements));
    const auto members = members_of(mesh, numbered);
    EXPECT_EQ(members[0].nodes.size(), 3u);
    EXPECT_EQ(members[1].nodes, (std::vector<std::int32_t>{0, 1, 2, 3}));
}

TEST(ExportMesh, ElementsOfGivenMeshesAreInSeveralGroupsOrInNone) {
    ExportMesh mesh = exported(tetrahedron());
    mesh.groups = {};
    set_groups(mesh, {{"both", {{0, {1, 2, 2}}}}, {"second", {{0, {2}}}}});
    const auto numbered = mesh.numbered(1);
    const auto members = members_of(mesh, numbered);
    ASSERT_EQ(members.size(), 2u);
    EXPECT_EQ(members[0].elements.size(), 2u);
    EXPECT_EQ(members[1].elements.size(), 1u);
    EXPECT_EQ(mesh.first_group(mesh.triangles(), 0), -1);
    const auto parts = divided(mesh, numbered);
    ASSERT_EQ(parts.size(), 2u) << "all of the second group are in the first one";
    EXPECT_EQ(parts[1].name, "others");
    EXPECT_EQ(Properties(mesh, numbered).names(), (std::vector<std::string>{"patch both", "other faces"}));
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
