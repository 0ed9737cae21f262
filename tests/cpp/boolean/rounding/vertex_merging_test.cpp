// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/vertex_merging.h"

#include <gtest/gtest.h>

#include "mesh/quality/surface_verification.h"

namespace mq::boolean {
namespace {

ResultMesh draft_of(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
    ResultMesh draft;
    draft.vertices = vertices;
    draft.made.assign(vertices.size(), kConstructed);
    draft.triangles = triangles;
    draft.source.resize(triangles.size());
    draft.from.assign(triangles.size(), 0);
    draft.displacement.assign(triangles.size(), 0.0);
    return draft;
}

/// A double pyramid over a ring of six vertices.
std::vector<Triangle> double_pyramid() {
    std::vector<Triangle> triangles;
    for (std::int32_t i = 0; i < 6; ++i) {
        triangles.push_back({i, (i + 1) % 6, 6});
        triangles.push_back({(i + 1) % 6, i, 7});
    }
    return triangles;
}

TEST(VertexMerging, CollapsesAnEdgeWhoseEndsAreInOnePlace) {
    ResultMesh draft =
        draft_of({{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {-1, -2, 0}, {0, 0, 1}, {0, 0, -1}},
                 double_pyramid());
    EXPECT_TRUE(merge_coincident_vertices(draft));
    EXPECT_EQ(draft.triangles.size(), 10u);
    EXPECT_EQ(draft.vertices.size(), 7u);
    EXPECT_TRUE(mesh::verify(draft.vertices, draft.triangles).passed());
}

TEST(VertexMerging, LeavesWhatWouldBeNoManifold) {
    // The ring is pinched between two opposite vertices.
    const std::vector<Vec3> vertices{{0, 0, 0},   {1, 2, 0},  {-1, 2, 0}, {0, 0, 0},
                                     {-1, -2, 0}, {1, -2, 0}, {0, 0, 1},  {0, 0, -1}};
    ResultMesh draft = draft_of(vertices, double_pyramid());
    EXPECT_FALSE(merge_coincident_vertices(draft));
    EXPECT_EQ(draft.triangles, double_pyramid());
    EXPECT_EQ(draft.vertices, vertices);
}

TEST(VertexMerging, LeavesASurfaceWithoutThemAlone) {
    const std::vector<Vec3> vertices{{2, 0, 0},   {1, 2, 0},  {-1, 2, 0}, {-2, 0, 0},
                                     {-1, -2, 0}, {1, -2, 0}, {0, 0, 1},  {0, 0, -1}};
    ResultMesh draft = draft_of(vertices, double_pyramid());
    EXPECT_FALSE(merge_coincident_vertices(draft));
    EXPECT_EQ(draft.vertices, vertices);
}

}  // namespace
}  // namespace mq::boolean
