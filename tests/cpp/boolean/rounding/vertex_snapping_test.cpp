// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/vertex_snapping.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boolean/random_meshes.h"

namespace mq::boolean {
namespace {

ResultMesh draft_of(const mesh::TriangleMesh& mesh) {
    ResultMesh draft;
    draft.vertices = mesh.vertices;
    draft.made.assign(mesh.vertices.size(), kConstructed);
    draft.triangles = mesh.triangles;
    draft.source.resize(mesh.triangles.size());
    draft.from.assign(mesh.triangles.size(), 0);
    draft.displacement.assign(mesh.triangles.size(), 0.0);
    return draft;
}

std::vector<Triangle> living(const RoundedSurface& surface) {
    std::vector<Triangle> result;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(surface.triangles().size()); ++t) {
        if (surface.alive(t)) {
            result.push_back(surface.triangle(t));
        }
    }
    return result;
}

std::vector<TrianglePair> all_contacts(const RoundedSurface& surface) {
    std::vector<std::int32_t> alive;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(surface.triangles().size()); ++t) {
        if (surface.alive(t)) {
            alive.push_back(t);
        }
    }
    return contacts_of(surface, alive, Progress());
}

/// New vertices stay where they are.
Vec3 same(const Vec3& p) {
    return p;
}

/// Two tetrahedra: the tip of the one pokes through a face of the other by 1e-3.
mesh::TriangleMesh poking(const Vec3& tip) {
    mesh::TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, -4}, tip, {1, 1, 3}, {2, 1, 3}, {1, 2, 3}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {5, 6, 7}, {5, 4, 6}, {6, 4, 7}, {7, 4, 5}};
    return mesh;
}

/// Two tetrahedra with crossed edges, which cut into each other by 1e-3 far from all vertices.
TEST(VertexSnapping, CrossedEdgesGetACommonVertex) {
    mesh::TriangleMesh mesh;
    mesh.vertices = {{-2, 0, 0},     {2, 0, 0},     {0, 1, -2}, {0, -1, -2},
                     {0, -2, -1e-3}, {0, 2, -1e-3}, {1, 0, 2},  {-1, 0, 2}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 5, 6}, {4, 7, 5}, {5, 7, 6}, {7, 4, 6}};
    for (std::size_t t = 0; t < 8; ++t) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][t < 4 ? 2 : 1]);
    }
    RoundedSurface surface(draft_of(mesh));
    surface.index_added();
    const std::vector<TrianglePair> contacts = all_contacts(surface);
    ASSERT_FALSE(contacts.empty());
    EXPECT_EQ(snap_vertices(surface, contacts, 4e-3, same, Progress()),
              5u);  // a vertex, and four triangles led through
    ASSERT_EQ(surface.vertices().size(), 9u);
    EXPECT_LT((surface.at(8) - Vec3(0, 0, -5e-4)).norm(), 1e-9);
    EXPECT_TRUE(all_contacts(surface).empty());
}

TEST(VertexSnapping, AFaceIsLedThroughATip) {
    RoundedSurface surface(draft_of(poking({1.25, 1.25, -1e-3})));
    surface.index_added();
    const std::vector<TrianglePair> contacts = all_contacts(surface);
    ASSERT_FALSE(contacts.empty());
    EXPECT_GT(snap_vertices(surface, contacts, 2e-3, same, Progress()), 0u);
    const std::vector<Triangle> triangles = living(surface);
    EXPECT_EQ(triangles.size(), 10u);  // the face became three
    EXPECT_EQ(std::count_if(triangles.begin(), triangles.end(),
                            [](const Triangle& t) { return t[0] == 4 || t[1] == 4 || t[2] == 4; }),
              6);
    EXPECT_TRUE(all_contacts(surface).empty());
}

TEST(VertexSnapping, AnEdgeIsLedThroughATip) {
    RoundedSurface surface(draft_of(poking({2.0, 1e-4, -1e-4})));
    surface.index_added();
    EXPECT_GT(snap_vertices(surface, all_contacts(surface), 2e-3, same, Progress()), 0u);
    // Both triangles of the edge became two.
    EXPECT_EQ(living(surface).size(), 10u);
    EXPECT_TRUE(all_contacts(surface).empty());
}

TEST(VertexSnapping, ATipIsMergedWithACorner) {
    RoundedSurface surface(draft_of(poking({1e-4, 1e-4, -1e-4})));
    surface.index_added();
    EXPECT_GT(snap_vertices(surface, all_contacts(surface), 2e-3, same, Progress()), 0u);
    const std::vector<Triangle> triangles = living(surface);
    EXPECT_EQ(triangles.size(), 8u);
    EXPECT_TRUE(std::none_of(triangles.begin(), triangles.end(),
                             [](const Triangle& t) { return t[0] == 4 || t[1] == 4 || t[2] == 4; }));
}

TEST(VertexSnapping, FarCrossingsStay) {
    RoundedSurface surface(draft_of(poking({1.25, 1.25, -1.0})));
    surface.index_added();
    const std::vector<TrianglePair> contacts = all_contacts(surface);
    EXPECT_EQ(contacts.size(), 3u);
    EXPECT_EQ(snap_vertices(surface, contacts, 2e-3, same, Progress()), 0u);
    EXPECT_FALSE(surface.edited());
}

/// Whatever is snapped, every edge runs as often one way as the other.
TEST(VertexSnapping, TheSurfaceStaysClosed) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        fuzz::Random random(seed);
        mesh::TriangleMesh mesh = fuzz::sphere(3);
        for (Vec3& p : mesh.vertices) {
            // A coarse grid flattens and folds the surface.
            p = (p * random.real(0.99, 1.01) * 20.0).array().round().matrix() / 20.0;
        }
        RoundedSurface surface(draft_of(mesh));
        surface.index_added();
        snap_vertices(surface, all_contacts(surface), 0.06, same, Progress());
        std::map<std::pair<int, int>, int> edges;
        for (const Triangle& t : living(surface)) {
            for (std::size_t k = 0; k < 3; ++k) {
                ++edges[{t[k], t[(k + 1) % 3]}];
                --edges[{t[(k + 1) % 3], t[k]}];
            }
        }
        EXPECT_TRUE(std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; }))
            << "seed " << seed;
    }
}

}  // namespace
}  // namespace mq::boolean
