// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/self_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "mesh/intersection/all_contacts.h"
#include "mesh/intersection/tied_points.h"

namespace mq::mesh {
namespace {

void expect_same(const std::vector<ContactPair>& found, const std::vector<ContactPair>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].a, expected[i].a);
        EXPECT_EQ(found[i].b, expected[i].b);
        EXPECT_EQ(found[i].contact, expected[i].contact);
    }
}

TEST(SelfIntersection, FindsAllPairsOfASoup) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        TiedPoints point(seed);
        point.set_flat(seed % 4 == 0);
        std::vector<Vec3> vertices;
        for (int i = 0; i < 30; ++i) {
            vertices.push_back(point());
        }
        std::vector<Triangle> triangles;
        for (int i = 0; i < 24; ++i) {
            const int a = point.integer(0, 9);
            triangles.push_back({a, point.integer(10, 19), point.integer(20, 29)});
        }
        const std::vector<ContactPair> expected = brute_force(vertices, triangles);
        expect_same(self_intersections(vertices, triangles), expected);
        const std::vector<std::int32_t> subset{1, 2, 3, 5, 8, 13, 21};
        std::vector<ContactPair> with_subset;
        for (const ContactPair& pair : expected) {
            if (std::count(subset.begin(), subset.end(), pair.a) + std::count(subset.begin(), subset.end(), pair.b)) {
                with_subset.push_back(pair);
            }
        }
        expect_same(self_intersections_with(vertices, triangles, subset), with_subset);
        EXPECT_EQ(self_intersections(vertices, triangles, 3).size(), std::min<std::size_t>(3, expected.size()));
    }
}

TEST(SelfIntersection, WithASubsetOfManySmallAndSomeLargeTriangles) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    for (const double large : {0.0, 0.02, 0.5}) {
        std::vector<Vec3> vertices;
        std::vector<Triangle> triangles;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 center(real(random), real(random), real(random));
            const double size = 0.5 + 0.5 * real(random) < large ? 1.0 : 0.1;
            for (int k = 0; k < 3; ++k) {
                vertices.emplace_back(center + size * Vec3(real(random), real(random), real(random)));
            }
            triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        std::vector<std::int32_t> subset;
        std::vector<char> in_subset(3000, 0);
        for (std::int32_t t = 0; t < 3000; ++t) {
            // These triangles are gathered in one region of space, so that others lie outside of it.
            if (vertices[3 * t].x() > 0.7 && t % 3 == 0) {
                subset.push_back(t);
                in_subset[t] = 1;
            }
        }
        std::vector<ContactPair> expected;
        for (const ContactPair& pair : self_intersections(vertices, triangles)) {
            if (in_subset[pair.a] + in_subset[pair.b] > 0) {
                expected.push_back(pair);
            }
        }
        EXPECT_GT(expected.size(), 10u);
        expect_same(self_intersections_with(vertices, triangles, subset), expected);
    }
}

TEST(SelfIntersections, WithinALimitNothingIsMissedWhereverThePairsAre) {
    // A large sheet without faults, and a knot of crossing triangles in one place.
    constexpr int kSide = 150;
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (int y = 0; y <= kSide; ++y) {
        for (int x = 0; x <= kSide; ++x) {
            vertices.emplace_back(x, y, 0.0);
            const auto at = [](int i, int j) { return static_cast<std::int32_t>(j * (kSide + 1) + i); };
            if (x < kSide && y < kSide) {
                triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
                triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
            }
        }
    }
    // Triangles in the knot, all of which cross.
    constexpr int kKnot = 30;
    for (int k = 0; k < kKnot; ++k) {
        const double angle = M_PI * k / kKnot;
        const Vec3 along(std::cos(angle), std::sin(angle), 0.0);
        const auto first = static_cast<std::int32_t>(vertices.size());
        const Vec3 center(70.5, 70.5, 5.0);
        vertices.insert(vertices.end(), {center - along, center + along, center + Vec3(0.0, 0.0, 1.0 + 0.01 * k)});
        triangles.push_back({first, first + 1, first + 2});
    }
    const std::size_t pairs = kKnot * (kKnot - 1) / 2;
    ASSERT_EQ(self_intersections(vertices, triangles).size(), pairs);
    EXPECT_EQ(self_intersections(vertices, triangles, pairs + 1).size(), pairs);
    EXPECT_EQ(self_intersections(vertices, triangles, pairs - 1).size(), pairs - 1);
}

/// Their time would grow with the square of the number of triangles: minutes.
TEST(SelfIntersections, OfManyTrianglesInOnePlaceEndAtTheLimit) {
    const std::vector<Vec3> vertices{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const std::vector<Triangle> triangles(100'000, {0, 1, 2});
    EXPECT_EQ(self_intersections(vertices, triangles, 1000).size(), 1000u);
}

TEST(SelfIntersections, OfAWheelAreNone) {
    constexpr int kRim = 50'000;
    std::vector<Vec3> vertices{Vec3(0, 0, 1), Vec3(0, 0, -1)};
    std::vector<Triangle> triangles;
    for (int k = 0; k < kRim; ++k) {
        vertices.emplace_back(std::cos(2.0 * M_PI * k / kRim), std::sin(2.0 * M_PI * k / kRim), 0.0);
        const int next = (k + 1) % kRim;
        triangles.push_back({0, 2 + k, 2 + next});
        triangles.push_back({1, 2 + next, 2 + k});
    }
    EXPECT_TRUE(self_intersections(vertices, triangles).empty());
    // A needle along the axis beside the center goes through a triangle of each half.
    vertices.insert(vertices.end(), {Vec3(0.3, 0.3, -2), Vec3(0.3, 0.3 + 1e-9, 2), Vec3(0.3 + 1e-9, 0.3, 2)});
    triangles.push_back({kRim + 2, kRim + 3, kRim + 4});
    EXPECT_GE(self_intersections(vertices, triangles).size(), 2u);
}

}  // namespace
}  // namespace mq::mesh
