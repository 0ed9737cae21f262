// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/polygon_triangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "base/error.h"
#include "base/predicates.h"

namespace mq::mesh {
namespace {

double area(const std::vector<Vec3>& loop, const std::vector<Triangle>& triangles) {
    double sum = 0.0;
    for (const Triangle& t : triangles) {
        sum += 0.5 * (loop[t[1]] - loop[t[0]]).cross(loop[t[2]] - loop[t[0]]).norm();
    }
    return sum;
}

/// The directed edges of the triangles are those of the loop once, and inner ones once each way.
void expect_disk(std::size_t count, const std::vector<Triangle>& triangles) {
    ASSERT_EQ(triangles.size(), count - 2);
    std::map<std::array<int, 2>, int> edges;
    for (const Triangle& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            ++edges[{t[i], t[(i + 1) % 3]}];
        }
    }
    for (const auto& [edge, uses] : edges) {
        EXPECT_EQ(uses, 1);
        const bool of_loop = (edge[0] + 1) % int(count) == edge[1];
        EXPECT_NE(of_loop, edges.count({edge[1], edge[0]}) == 1) << edge[0] << "-" << edge[1];
    }
}

std::vector<Vec3> random_loop(int count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> real(-0.3, 0.3);
    std::vector<Vec3> loop;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * M_PI * i / count;
        loop.emplace_back(std::cos(angle) + real(random), std::sin(angle) + real(random), real(random));
    }
    return loop;
}

/// The least area over all triangulations, by plain recursion.
double least_area(const std::vector<Vec3>& loop, int i, int j) {
    if (j - i < 2) {
        return 0.0;
    }
    double best = INFINITY;
    for (int k = i + 1; k < j; ++k) {
        const double triangle = 0.5 * (loop[k] - loop[i]).cross(loop[j] - loop[i]).norm();
        best = std::min(best, triangle + least_area(loop, i, k) + least_area(loop, k, j));
    }
    return best;
}

TEST(HoleFilling, IsTheTriangulationOfLeastArea) {
    for (int count = 3; count <= 10; ++count) {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const std::vector<Vec3> loop = random_loop(count, seed);
            const std::vector<Triangle> triangles = fill_hole(loop);
            expect_disk(loop.size(), triangles);
            EXPECT_NEAR(area(loop, triangles), least_area(loop, 0, count - 1), 1e-12);
        }
    }
}

TEST(HoleFilling, AFlatConvexLoopIsFilledExactly) {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<Triangle> triangles = fill_hole(square);
    expect_disk(4, triangles);
    for (const Triangle& t : triangles) {
        EXPECT_EQ(orient3d(square[t[0]], square[t[1]], square[t[2]], Vec3(0, 0, 1)), 1);
    }
}

TEST(HoleFilling, LeavesOutDegenerateTrianglesThoughTheyHaveTheLeastArea) {
    // A square with many vertices on its sides: ears on a side would be free.
    std::vector<Vec3> loop;
    for (int side = 0; side < 4; ++side) {
        const Vec3 corners[5]{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
        for (int i = 0; i < 8; ++i) {
            loop.push_back(corners[side] + (corners[side + 1] - corners[side]) * (0.125 * i));
        }
    }
    const std::vector<Triangle> triangles = fill_hole(loop);
    expect_disk(loop.size(), triangles);
    EXPECT_NEAR(area(loop, triangles), 1.0, 1e-12);
    for (const Triangle& t : triangles) {
        EXPECT_FALSE(collinear(loop[t[0]], loop[t[1]], loop[t[2]]));
    }
}

TEST(HoleFilling, AvoidsWhatItIsToldToWherePossible) {
    const std::vector<Vec3> loop = random_loop(12, 3);
    const auto avoid = [](const Triangle& t) { return t[0] % 2 == 0 && t[1] % 2 == 0 && t[2] % 2 == 0; };
    const std::vector<Triangle> triangles = fill_hole(loop, avoid);
    expect_disk(loop.size(), triangles);
    for (const Triangle& t : triangles) {
        EXPECT_FALSE(avoid(t));
    }
    EXPECT_GE(area(loop, triangles), area(loop, fill_hole(loop)));
    const std::vector<Triangle> all_refused = fill_hole(loop, [](const Triangle&) { return true; });
    EXPECT_NEAR(area(loop, all_refused), area(loop, fill_hole(loop)), 1e-12);
}

TEST(HoleFilling, LongLoopsAreDividedAndFilled) {
    for (const int count : {int(kLongestWholeLoop), int(kLongestWholeLoop) + 1, 1500, 5000}) {
        std::vector<Vec3> loop;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * M_PI * i / count;
            loop.emplace_back((2.0 + std::cos(9.0 * angle)) * std::cos(angle),
                              (2.0 + std::cos(9.0 * angle)) * std::sin(angle), 0.1 * std::sin(5.0 * angle));
        }
        const std::vector<Triangle> triangles = fill_hole(loop);
        expect_disk(loop.size(), triangles);
        EXPECT_LT(area(loop, triangles), 1.2 * M_PI * 4.5);
    }
}

TEST(HoleFilling, ALineIsNoHole) {
    EXPECT_THROW(fill_hole({Vec3(0, 0, 0), Vec3(1, 0, 0)}), InvalidInput);
    // Every triangulation is degenerate: the answer is one all the same, for the caller to see.
    EXPECT_EQ(fill_hole({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)}).size(), 2u);
}

}  // namespace
}  // namespace mq::mesh
