// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/node_open.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boolean/closed_solids.h"
#include "layered_depth/reconstruction/directed_edge_set.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/quality/mesh_report.h"

namespace mq::layered_depth {

namespace solids = boolean::solids;
namespace {

/// Two boxes that share one vertex.
mesh::TriangleMesh pinched() {
    mesh::TriangleMesh mesh =
        solids::together(solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), solids::box(Vec3(1, 1, 1), Vec3(2, 2, 2)));
    for (mesh::Triangle& t : mesh.triangles) {
        std::replace(t.begin(), t.end(), 8, 7);
    }
    return mesh;
}

TEST(NodeOpen, DoublesAPinchedPoint) {
    mesh::TriangleMesh mesh = pinched();
    EXPECT_EQ(mesh::measure(mesh).pinched_vertices, 1U);
    const std::vector<std::uint8_t> all(mesh.vertices.size(), 1);
    const std::vector<std::int32_t> originals = open_nodes(mesh.vertices, mesh.triangles, all);
    EXPECT_EQ(originals, std::vector<std::int32_t>{7});
    EXPECT_EQ(mesh::measure(mesh).pinched_vertices, 0U);
    EXPECT_EQ(mesh.vertices.back(), Vec3(1, 1, 1));
    EXPECT_TRUE(find_holes(mesh.triangles, std::vector<std::uint8_t>(mesh.vertices.size(), 1)).empty());
    EXPECT_FALSE(mesh::self_intersections(mesh.vertices, mesh.triangles).empty());
    // The first box is retained: only the second moves.
    std::vector<std::int32_t> source(24, -1);
    std::fill(source.begin(), source.begin() + 12, 0);
    const auto copy = static_cast<std::int32_t>(mesh.vertices.size()) - 1;
    separate_nodes(mesh.vertices, mesh.triangles, source, originals, copy, 0.01);
    EXPECT_EQ(mesh.vertices[7], Vec3(1, 1, 1));
    EXPECT_NEAR((mesh.vertices[copy] - Vec3(1, 1, 1)).norm(), 0.01, 1e-6);
    EXPECT_TRUE(mesh::self_intersections(mesh.vertices, mesh.triangles).empty());
}

TEST(NodeOpen, TwoHolesAtOnePointBecomeTwoLoops) {
    // A sphere without two triangles that meet in a point only.
    mesh::TriangleMesh mesh = solids::sphere(Vec3(0, 0, 0), 1.0, 6);
    std::vector<mesh::Triangle> kept;
    int around = 0;
    for (const mesh::Triangle& t : mesh.triangles) {
        const bool at_pole = t[0] == 0 || t[1] == 0 || t[2] == 0;
        around += at_pole ? 1 : 0;
        if (!at_pole || (around != 1 && around != 5)) {
            kept.push_back(t);
        }
    }
    ASSERT_EQ(kept.size() + 2, mesh.triangles.size());
    const std::vector<std::uint8_t> all(mesh.vertices.size(), 1);
    EXPECT_EQ(open_nodes(mesh.vertices, kept, all).size(), 1U);
    const auto holes = find_holes(kept, std::vector<std::uint8_t>(mesh.vertices.size(), 1));
    ASSERT_EQ(holes.size(), 1U);  // the two fans at the pole separate, and the two holes are one
    EXPECT_EQ(holes[0].size(), 6U);
    EdgeSet edges;
    for (const mesh::Triangle& t : kept) {
        edges.add(t);
    }
    for (std::size_t i = 0; i < holes[0].size(); ++i) {
        const std::int32_t from = holes[0][i], to = holes[0][(i + 1) % holes[0].size()];
        EXPECT_TRUE(edges.has(to, from));
        EXPECT_FALSE(edges.has(from, to));
    }
}

TEST(EdgeSet, AdmitsEachDirectionOnce) {
    EdgeSet edges;
    EXPECT_TRUE(edges.admits({0, 1, 2}));
    edges.add(mesh::Triangle{0, 1, 2});
    EXPECT_FALSE(edges.admits({0, 1, 3}));
    EXPECT_TRUE(edges.admits({1, 0, 3}));
    EXPECT_FALSE(edges.admits({4, 4, 3}));
    for (int k = 10; k < 5000; ++k) {
        edges.add(k, 3 * k);
    }
    for (int k = 10; k < 5000; ++k) {
        EXPECT_TRUE(edges.has(k, 3 * k));
        EXPECT_FALSE(edges.has(3 * k, k));
    }
}

TEST(OppositeDuplicates, AreTakenOutAndNothingElse) {
    mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const std::vector<mesh::Triangle> box = mesh.triangles;
    std::vector<mesh::Triangle> triangles = box;
    triangles.insert(triangles.begin() + 3, {8, 9, 10});
    triangles.push_back({9, 8, 10});
    std::vector<std::int32_t> source(triangles.size(), 7);
    source[3] = source.back() = -1;
    std::vector<std::uint8_t> candidate(11, 1);
    const std::vector<std::size_t> dropped = drop_opposite_duplicates(triangles, source, candidate);
    EXPECT_EQ(dropped, (std::vector<std::size_t>{3, 13}));
    EXPECT_EQ(triangles, box);
    EXPECT_EQ(source, std::vector<std::int32_t>(box.size(), 7));
    EXPECT_TRUE(drop_opposite_duplicates(triangles, source, candidate).empty());
    EXPECT_EQ(triangles, box);
}

}  // namespace
}  // namespace mq::layered_depth
