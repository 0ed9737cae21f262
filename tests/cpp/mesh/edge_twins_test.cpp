// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/edge_twins.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <set>

#include "mesh/sample_meshes.h"
#include "mesh/vertex_stars.h"
#include "mesh/weld.h"

namespace mq::mesh {
namespace {

std::vector<Triangle> random_triangles(std::uint64_t seed, int vertices, int count) {
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> vertex(0, vertices - 1);
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
        triangles.push_back({vertex(random), vertex(random), vertex(random)});
    }
    return triangles;
}

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

TEST(Fans, OneForEachSheetAtAVertex) {
    const TriangleMesh torus = samples::torus(8);
    const std::vector<std::int32_t> closed = edge_twins(torus.triangles, torus.vertices.size());
    EXPECT_EQ(fans(torus.triangles, closed).vertex_of.size(), torus.vertices.size());
    EXPECT_EQ(components(closed).count, 1);
    // Two tetrahedra that meet in vertex 0, the second one open.
    const std::vector<Triangle> pair{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 4, 5}, {0, 5, 6}};
    const std::vector<std::int32_t> twins = edge_twins(pair, 7);
    const Fans found = fans(pair, twins);
    EXPECT_EQ(found.vertex_of.size(), 8u);
    EXPECT_EQ(found.fan_of[0], found.fan_of[3]);
    EXPECT_NE(found.fan_of[0], found.fan_of[12]);
    EXPECT_EQ(found.fan_of[12], found.fan_of[15]);
    EXPECT_EQ(components(twins).count, 2);
}

TEST(VertexStars, HaveAllCornersInOrder) {
    const std::vector<Triangle> triangles = random_triangles(3, 10, 50);
    const VertexStars stars(triangles, 10);
    std::size_t sum = 0;
    for (std::size_t v = 0; v < 10; ++v) {
        std::uint32_t previous = 0;
        for (const std::uint32_t corner : stars[v]) {
            EXPECT_EQ(triangles[corner / 3][corner % 3], static_cast<std::int32_t>(v));
            EXPECT_TRUE(corner > previous || corner == *stars[v].first);
            previous = corner;
        }
        sum += stars[v].size();
    }
    EXPECT_EQ(sum, 150u);
}

TEST(Weld, FindsTheFirstOfEqualVertices) {
    std::mt19937_64 random(4);
    std::uniform_int_distribution<int> integer(-2, 2);
    std::vector<Vec3> vertices;
    for (int i = 0; i < 400; ++i) {
        vertices.emplace_back(0.1 * integer(random), 0.1 * integer(random), 0.1 * integer(random));
    }
    vertices.emplace_back(-0.0, 0.0, -0.0);
    vertices.emplace_back(std::numeric_limits<double>::denorm_min(), 0.0, 0.0);
    const std::vector<std::int32_t> found = equal_vertices(vertices);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        std::int32_t first = 0;
        while (vertices[first] != vertices[v]) {
            ++first;
        }
        EXPECT_EQ(found[v], first);
    }
}

}  // namespace
}  // namespace mq::mesh
