// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/planar_pieces.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace mq::boolean {
namespace {

/// How often each directed edge runs, less how often it runs back.
std::map<std::pair<int, int>, int> border(const std::vector<Triangle>& triangles) {
    std::map<std::pair<int, int>, int> edges;
    for (const Triangle& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{t[k], t[(k + 1) % 3]}];
            --edges[{t[(k + 1) % 3], t[k]}];
        }
    }
    for (auto it = edges.begin(); it != edges.end();) {
        it = it->second <= 0 ? edges.erase(it) : std::next(it);
    }
    return edges;
}

double area(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
    double sum = 0.0;
    for (const Triangle& t : triangles) {
        const Vec3& a = vertices[static_cast<std::size_t>(t[0])];
        sum += 0.5 *
               (vertices[static_cast<std::size_t>(t[1])] - a).cross(vertices[static_cast<std::size_t>(t[2])] - a).z();
    }
    return sum;
}

TEST(PlanarPieces, WithoutPointsItIsTheTriangle) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    PlanarPieces division(vertices, {0, 1, 2});
    EXPECT_EQ(division.run(), (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(PlanarPieces, PointsOnAnEdgeAreOnTheBorderInTheirOrder) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 0, 0}, {3, 0, 0}, {2, 2, 0}, {1, 1, 0}};
    PlanarPieces division(vertices, {0, 1, 2});
    division.add_on_edge(0, 0.25, 3);
    division.add_on_edge(0, 0.75, 4);
    division.add_on_edge(1, 0.5, 5);
    division.add_inside(6);
    const std::vector<Triangle> pieces = division.run();
    EXPECT_EQ(pieces.size(), 6u);
    EXPECT_EQ(border(pieces), (std::map<std::pair<int, int>, int>{
                                  {{0, 3}, 1}, {{3, 4}, 1}, {{4, 1}, 1}, {{1, 5}, 1}, {{5, 2}, 1}, {{2, 0}, 1}}));
    EXPECT_DOUBLE_EQ(area(vertices, pieces), 8.0);
}

/// The pieces of a needle go across it: no diagonal is much longer than the needle is wide.
TEST(PlanarPieces, DiagonalsOfANeedleAreShort) {
    std::vector<Vec3> vertices{{0, 0, 0}, {100, 0, 0}, {100, 1, 0}};
    PlanarPieces division(vertices, {0, 1, 2});
    std::vector<std::pair<double, int>> low;
    for (int i = 1; i < 100; ++i) {
        vertices.emplace_back(i, 0, 0);
    }
    for (int i = 99; i > 0; --i) {
        vertices.emplace_back(i, 0.01 * i, 0);
    }
    for (int i = 0; i < 99; ++i) {
        division.add_on_edge(0, 0.01 * (i + 1), 3 + i);
        division.add_on_edge(2, 0.01 * (i + 1), 102 + i);
    }
    const std::vector<Triangle> pieces = division.run();
    EXPECT_EQ(pieces.size(), 199u);
    double longest = 0.0;
    for (const Triangle& t : pieces) {
        for (std::size_t k = 0; k < 3; ++k) {
            longest = std::max(
                longest,
                (vertices[static_cast<std::size_t>(t[k])] - vertices[static_cast<std::size_t>(t[(k + 1) % 3])]).norm());
        }
    }
    EXPECT_LT(longest, 2.0);
    EXPECT_NEAR(area(vertices, pieces), 50.0, 1e-9);
}

TEST(PlanarPieces, BordersHoldForRandomPoints) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> real(0.0, 1.0);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {real(random), 1e-3 * real(random) + 1e-6, 0}};
        PlanarPieces division(vertices, {0, 1, 2});
        std::map<std::pair<int, int>, int> expected;
        for (std::size_t k = 0; k < 3; ++k) {
            std::vector<double> places;
            for (int i = 0; i < 5; ++i) {
                places.push_back(0.001 + 0.998 * real(random));
            }
            std::sort(places.begin(), places.end());
            int from = static_cast<int>(k);
            for (const double s : places) {
                const auto w = static_cast<std::int32_t>(vertices.size());
                vertices.emplace_back((1.0 - s) * vertices[k] + s * vertices[(k + 1) % 3]);
                division.add_on_edge(k, s, w);
                expected[{from, w}] = 1;
                from = w;
            }
            expected[{from, static_cast<int>((k + 1) % 3)}] = 1;
        }
        const Vec3 inside = (vertices[0] + vertices[1] + vertices[2]) / 3.0;
        vertices.push_back(inside);
        division.add_inside(static_cast<std::int32_t>(vertices.size()) - 1);
        EXPECT_EQ(border(division.run()), expected) << "round " << round;
    }
}

}  // namespace
}  // namespace mq::boolean
