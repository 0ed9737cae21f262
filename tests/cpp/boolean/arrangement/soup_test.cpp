// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/soup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "boolean/soups.h"

namespace mq::boolean {
namespace {

std::size_t vertices_in_use(const Soup& soup) {
    std::set<std::int32_t> used;
    for (const Triangle& t : soup.triangles) {
        used.insert(t.begin(), t.end());
    }
    return used.size();
}

/// Two cubes of side 1 that share a side.
Soup stacked_cubes() {
    return soups::soup_of({solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), solids::box(Vec3(0, 0, 1), Vec3(1, 1, 2))});
}

TEST(Soup, VerticesInOnePlaceGetOneIndexWhereBoxesMeet) {
    Soup soup = stacked_cubes();
    EXPECT_EQ(vertices_in_use(soup), 16u);
    merge_vertices(soup, operand_boxes(soup));
    EXPECT_EQ(vertices_in_use(soup), 12u);
    Soup apart = soups::soup_of({solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), solids::box(Vec3(2, 0, 0), Vec3(3, 1, 1))});
    merge_vertices(apart, operand_boxes(apart));
    EXPECT_EQ(vertices_in_use(apart), 16u);
}

TEST(Soup, MergingByPairsTouchesTheirVerticesOnly) {
    Soup soup = stacked_cubes();
    merge_touching(soup, {});
    EXPECT_EQ(vertices_in_use(soup), 16u);
    merge_touching(soup, soups::pairs_of(soup));
    EXPECT_EQ(vertices_in_use(soup), 12u);
}

TEST(Soup, SheetsOfOneOperandThatAreMergedAreMarked) {
    Soup soup = stacked_cubes();
    merge_vertices(soup, operand_boxes(soup));
    EXPECT_TRUE(std::none_of(soup.shared.begin(), soup.shared.end(), [](char c) { return c != 0; }));
    const mesh::TriangleMesh touching =
        solids::together(solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), solids::box(Vec3(1, 1, 0), Vec3(2, 2, 1)));
    Soup two = soups::soup_of({touching, solids::box(Vec3(0.5, 0.5, -1), Vec3(1.5, 1.5, 1.5))});
    merge_vertices(two, operand_boxes(two));
    for (std::size_t v = 0; v < two.vertices.size(); ++v) {
        const Vec3& p = two.vertices[v];
        const bool first_of_edge = v < 8 && p.x() == 1.0 && p.y() == 1.0;
        EXPECT_EQ(v < two.shared.size() && two.shared[v] != 0, first_of_edge) << v;
    }
}

TEST(CoincidentTriangles, AreFoundWithTheirOrientation) {
    Soup soup = stacked_cubes();
    merge_vertices(soup, operand_boxes(soup));
    const std::vector<CoincidentTriangle> twins = find_twins(soup);
    ASSERT_EQ(twins.size(), 2u);
    for (const CoincidentTriangle& twin : twins) {
        EXPECT_EQ(twin.turn, -1) << "the outer sides of the cubes face each other there";
        Triangle a = soup.triangles[static_cast<std::size_t>(twin.triangle)];
        Triangle b = soup.triangles[static_cast<std::size_t>(twin.of)];
        std::sort(a.begin(), a.end());
        std::sort(b.begin(), b.end());
        EXPECT_EQ(a, b);
    }
    Soup same = soups::soup_of({solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1))});
    merge_vertices(same, operand_boxes(same));
    const std::vector<CoincidentTriangle> all = find_twins(same);
    EXPECT_EQ(all.size(), 12u);
    EXPECT_TRUE(std::all_of(all.begin(), all.end(), [](const CoincidentTriangle& twin) { return twin.turn == 1; }));
}

TEST(Soup, TrianglesAtMovedVerticesAreNoOperandsOwn) {
    Soup soup = stacked_cubes();
    forget_moved_triangles(soup);
    EXPECT_EQ(soup.source[0].triangle, 0);
    soup.moved.assign(soup.vertices.size(), 0);
    soup.moved[0] = 1;
    forget_moved_triangles(soup);
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const Triangle& c = soup.triangles[t];
        EXPECT_EQ(soup.source[t].triangle < 0, c[0] == 0 || c[1] == 0 || c[2] == 0) << t;
    }
}

}  // namespace
}  // namespace mq::boolean
