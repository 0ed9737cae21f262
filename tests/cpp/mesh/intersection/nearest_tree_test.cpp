// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/nearest_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/intersection/triangle_distance.h"
#include "mesh/intersection/triangle_soup.h"

namespace mq::mesh {
namespace {

class NearestTreeTest : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Soups, NearestTreeTest, testing::Range(0, int(Soup::kKinds)));

TEST_P(NearestTreeTest, NearestPointIsTheNearest) {
    const Soup soup(GetParam(), 250, 10);
    const Soup queries(GetParam(), 60, 11);
    const NearestTree tree(soup.vertices, soup.triangles);
    for (const Vec3& p : queries.vertices) {
        ClosestPoint expected;
        for (std::int32_t i = 0; i < 250; ++i) {
            const Triangle& t = soup.triangles[i];
            const Vec3 q = nearest_on_triangle(p, soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]);
            if ((q - p).norm() < expected.distance) {
                expected = {i, q, (q - p).norm()};
            }
        }
        const ClosestPoint found = tree.nearest(p);
        EXPECT_EQ(found.triangle, expected.triangle);
        EXPECT_EQ(found.distance, expected.distance);
        EXPECT_EQ(tree.nearest(p, 1.001 * expected.distance + 1e-12).triangle, expected.triangle);
        if (expected.distance > 0.0) {
            EXPECT_EQ(tree.nearest(p, 0.999 * expected.distance).triangle, -1);
        }
    }
}

TEST_P(NearestTreeTest, AGuessChangesNoAnswer) {
    const Soup soup(GetParam(), 250, 20);
    const Soup queries(GetParam(), 60, 21);
    const NearestTree tree(soup.vertices, soup.triangles);
    std::int32_t guess = 0;
    for (const Vec3& p : queries.vertices) {
        guess = (guess + 97) % 250;
        const ClosestPoint expected = tree.nearest(p);
        for (const std::int32_t from : {guess, expected.triangle}) {
            const ClosestPoint found = tree.nearest_from(p, from);
            EXPECT_EQ(found.triangle, expected.triangle);
            EXPECT_EQ(found.point, expected.point);
            EXPECT_EQ(found.distance, expected.distance);
            EXPECT_GE(tree.any_within(p, expected.distance, from), 0);
            if (expected.distance > 0.0) {
                EXPECT_EQ(tree.any_within(p, std::nextafter(expected.distance, 0.0), from), -1);
            }
        }
        const std::int32_t some = tree.any_within(p, 2.0 * expected.distance, guess);
        ASSERT_GE(some, 0);
        const Triangle& t = soup.triangles[some];
        EXPECT_LE((nearest_on_triangle(p, soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]) - p).norm(),
                  2.0 * expected.distance);
    }
}

TEST_P(NearestTreeTest, ASubsetIsATreeOfItsOwn) {
    const Soup soup(GetParam(), 200, 13);
    std::vector<std::int32_t> odd;
    for (std::int32_t i = 1; i < 200; i += 2) {
        odd.push_back(i);
    }
    const NearestTree tree(soup.vertices, soup.triangles, odd);
    for (const Vec3& p : soup.vertices) {
        EXPECT_EQ(tree.nearest(p).triangle % 2, 1);
    }
}

TEST(NearestTree, NothingIsNearInAnEmptyTree) {
    const std::vector<Vec3> vertices;
    const std::vector<Triangle> triangles;
    EXPECT_EQ(NearestTree(vertices, triangles).nearest(Vec3(0, 0, 0)).triangle, -1);
}

TEST(NearestTree, MissesNothingBeyondSinglePrecision) {
    for (const double size : {1e39, 1e120}) {
        Soup soup(Soup::kRandom, 60, 5);
        for (Vec3& p : soup.vertices) {
            p *= size;
        }
        const NearestTree tree(soup.vertices, soup.triangles);
        for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
            EXPECT_EQ(tree.nearest(soup.vertices[3 * i]).distance, 0.0);
        }
    }
}

}  // namespace
}  // namespace mq::mesh
