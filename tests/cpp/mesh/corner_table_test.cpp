// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/corner_table.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "mesh/random_triangles.h"
#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

TEST(EdgeTwins, AreTheDefinitionOnRandomTriangles) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const int vertices = seed % 2 == 0 ? 8 : 40;
        const std::vector<Triangle> triangles = random_triangles(seed, vertices, 60);
        std::map<std::set<int>, std::vector<int>> corners;
        for (int h = 0; h < 180; ++h) {
            const Triangle& t = triangles[h / 3];
            if (std::set<int>(t.begin(), t.end()).size() == 3) {
                corners[{t[h % 3], t[(h + 1) % 3]}].push_back(h);
            }
        }
        const std::vector<std::int32_t> twins = edge_twins(triangles, vertices);
        ASSERT_EQ(twins.size(), 180u);
        for (int h = 0; h < 180; ++h) {
            const Triangle& t = triangles[h / 3];
            int expected = kIrregular;
            if (std::set<int>(t.begin(), t.end()).size() == 3) {
                const std::vector<int>& all = corners[{t[h % 3], t[(h + 1) % 3]}];
                const int other = all.size() == 2 ? all[0] + all[1] - h : -1;
                if (all.size() == 1) {
                    expected = kBorder;
                } else if (all.size() == 2 && triangles[other / 3][other % 3] != t[h % 3]) {
                    expected = other;
                }
            }
            EXPECT_EQ(twins[h], expected);
        }
    }
}

TEST(EdgeTwins, ManyTrianglesAtOneVertex) {
    std::vector<Triangle> fan;
    for (int i = 0; i < 1000; ++i) {
        fan.push_back({0, 1 + i, 1 + (i + 1) % 1000});
    }
    const std::vector<std::int32_t> twins = edge_twins(fan, 1001);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_EQ(twins[3 * i], 3 * ((i + 999) % 1000) + 2);
        EXPECT_EQ(twins[3 * i + 1], kBorder);
    }
    EXPECT_EQ(fans(fan, twins).vertex_of.size(), 1001u);
}

TEST(VertexFans, OneForEachSheetAtAVertex) {
    const TriangleMesh torus = samples::torus(8);
    const std::vector<std::int32_t> closed = edge_twins(torus.triangles, torus.vertices.size());
    EXPECT_EQ(fans(torus.triangles, closed).vertex_of.size(), torus.vertices.size());
    EXPECT_EQ(components(closed).count, 1);
    // Two tetrahedra that meet in vertex 0, the second one open.
    const std::vector<Triangle> pair{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 4, 5}, {0, 5, 6}};
    const std::vector<std::int32_t> twins = edge_twins(pair, 7);
    const VertexFans found = fans(pair, twins);
    EXPECT_EQ(found.vertex_of.size(), 8u);
    EXPECT_EQ(found.fan_of[0], found.fan_of[3]);
    EXPECT_NE(found.fan_of[0], found.fan_of[12]);
    EXPECT_EQ(found.fan_of[12], found.fan_of[15]);
    EXPECT_EQ(components(twins).count, 2);
}

}  // namespace
}  // namespace mq::mesh
