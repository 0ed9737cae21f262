// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/local_operations.h"

#include <gtest/gtest.h>

#include "base/angle.h"
#include "improve/flat_grid.h"
#include "mesh/quality/mesh_report.h"

namespace mq::improve {
namespace {

constexpr double kFeature = 35.0 * kDegree;

/// A grid of 4 by 4 squares: vertex 12 is its middle, 6 and 18 its neighbours along the diagonals.
EditableMesh grid() {
    return {flat_grid(4), kFeature};
}

void expect_the_square(const EditableMesh& mesh) {
    const mesh::MeshReport report = mesh::measure(mesh.result());
    EXPECT_TRUE(report.oriented);
    EXPECT_TRUE(report.manifold);
    EXPECT_NEAR(report.area, 16.0, 1e-12);
    EXPECT_EQ(report.euler, 1);
}

TEST(LocalOperations, ASwapJoinsTheOtherTwoCorners) {
    EditableMesh mesh = grid();
    const auto swap = swap_edge(mesh, 6, 12);
    ASSERT_TRUE(swap);
    mesh.apply(*swap);
    EXPECT_TRUE(mesh.around_edge(6, 12).empty());
    EXPECT_EQ(mesh.around_edge(7, 11).size(), 2u);
    EXPECT_EQ(mesh.alive_count(), 32);
    expect_the_square(mesh);
    EXPECT_FALSE(swap_edge(mesh, 0, 1)) << "an edge of the border";
}

TEST(LocalOperations, ACollapseTakesAVertexAndTwoTriangles) {
    EditableMesh mesh = grid();
    const auto collapse = collapse_edge(mesh, 12, 13, kFeature);
    ASSERT_TRUE(collapse);
    mesh.apply(*collapse);
    EXPECT_TRUE(mesh.star(12).empty());
    EXPECT_EQ(mesh.alive_count(), 30);
    expect_the_square(mesh);
    EXPECT_FALSE(collapse_edge(mesh, 0, 6, kFeature)) << "a corner of the border";
    EXPECT_FALSE(collapse_edge(mesh, 2, 7, kFeature)) << "off its sharp edge";
    EXPECT_TRUE(collapse_edge(mesh, 2, 3, kFeature)) << "along a straight one";
}

TEST(LocalOperations, NoCollapseLaysTwoTrianglesOnEachOther) {
    mesh::TriangleMesh tetrahedron;
    tetrahedron.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const EditableMesh mesh(tetrahedron, M_PI);
    EXPECT_FALSE(collapse_edge(mesh, 0, 1, kFeature));
}

TEST(LocalOperations, ASplitPutsAVertexOnTheEdge) {
    EditableMesh mesh = grid();
    const int middle = mesh.add_vertex(0.5 * (mesh.point(0) + mesh.point(1)));
    mesh.apply(split_edge(mesh, 0, 1, middle));
    EXPECT_EQ(mesh.alive_count(), 33);
    EXPECT_FALSE(mesh.is_sharp(0, 1));
    EXPECT_TRUE(mesh.is_sharp(0, middle)) << "both halves of a sharp edge are";
    EXPECT_TRUE(mesh.is_sharp(middle, 1));
    expect_the_square(mesh);
}

TEST(LocalOperations, AVertexIsReplacedWithAllItsTriangles) {
    EditableMesh mesh = grid();
    const int other = mesh.add_vertex(Vec3(2.1, 1.9, 0.0));
    mesh.apply(replace_vertex(mesh, 12, other));
    EXPECT_TRUE(mesh.star(12).empty());
    EXPECT_EQ(mesh.star(other).size(), 6u);
    EXPECT_EQ(mesh.alive_count(), 32);
    expect_the_square(mesh);
}

TEST(LocalOperations, FreedomIsThatOfTheSharpEdges) {
    const EditableMesh mesh = grid();
    EXPECT_EQ(freedom(mesh, 12, kFeature), Freedom::Surface);
    EXPECT_EQ(freedom(mesh, 2, kFeature), Freedom::Curve);
    EXPECT_EQ(freedom(mesh, 0, kFeature), Freedom::None);
}

}  // namespace
}  // namespace mq::improve
