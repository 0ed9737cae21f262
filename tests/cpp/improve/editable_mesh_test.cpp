// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/editable_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/angle.h"
#include "improve/flat_grid.h"
#include "improve/local_operations.h"

namespace mq::improve {
namespace {

std::vector<std::vector<int>> stars(const EditableMesh& mesh) {
    std::vector<std::vector<int>> result;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        result.push_back(mesh.star(v));
        std::sort(result.back().begin(), result.back().end());
    }
    return result;
}

TEST(EditableMesh, AnEarlierStateComesBack) {
    EditableMesh mesh(flat_grid(4), 35.0 * kDegree);
    mesh.apply(*swap_edge(mesh, 6, 12));
    const EditableMesh then = mesh;
    const EditableMesh::State state = mesh.state();

    const int inner = mesh.add_vertex(Vec3(2.5, 2.5, 0));
    mesh.apply(split_edge(mesh, 12, 18, inner));
    const int border = mesh.add_vertex(Vec3(0.5, 0, 0));
    mesh.apply(split_edge(mesh, 0, 1, border));
    mesh.apply(*collapse_edge(mesh, 8, 13, 35.0 * kDegree));
    ASSERT_FALSE(mesh.is_sharp(0, 1));
    ASSERT_TRUE(mesh.star(8).empty());
    ASSERT_NE(mesh.alive_count(), then.alive_count());

    mesh.restore(state);
    EXPECT_EQ(mesh.vertex_count(), then.vertex_count());
    EXPECT_EQ(mesh.triangle_count(), then.triangle_count());
    EXPECT_EQ(mesh.alive_count(), then.alive_count());
    EXPECT_EQ(stars(mesh), stars(then));
    EXPECT_TRUE(mesh.is_sharp(0, 1));
    EXPECT_EQ(mesh.result().triangles, then.result().triangles);
    EXPECT_EQ(mesh.result().vertices, then.result().vertices);
}

}  // namespace
}  // namespace mq::improve
