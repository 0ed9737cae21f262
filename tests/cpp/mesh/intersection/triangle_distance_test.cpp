// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/triangle_distance.h"

#include <gtest/gtest.h>

#include <random>

namespace mq::mesh {
namespace {

const Corners kBase{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

TEST(TriangleDistance, OfVertexAndPlane) {
    const TriangleDistance found = triangle_distance(kBase, {Vec3(1, 1, 0.5), Vec3(1, 2, 3), Vec3(2, 1, 3)});
    EXPECT_DOUBLE_EQ(found.distance, 0.5);
    EXPECT_EQ(found.on_first, Vec3(1, 1, 0));
    EXPECT_EQ(found.on_second, Vec3(1, 1, 0.5));
    EXPECT_EQ(found.depth, 0.0);
}

TEST(TriangleDistance, OfEdges) {
    // Crosswise over the edge y = 0, one above and outside.
    const TriangleDistance found = triangle_distance(kBase, {Vec3(2, -0.3, -1), Vec3(2, -0.3, 1), Vec3(2, -3, 0)});
    EXPECT_NEAR(found.distance, 0.3, 1e-15);
    EXPECT_LT((found.on_first - Vec3(2, 0, 0)).norm(), 1e-15);
}

TEST(TriangleDistance, IsZeroWhereTheyMeetAndTellsHowDeep) {
    const TriangleDistance through = triangle_distance(kBase, {Vec3(1, 1, -0.25), Vec3(1, 1, 2), Vec3(9, 9, 2)});
    EXPECT_EQ(through.distance, 0.0);
    EXPECT_DOUBLE_EQ(through.depth, 0.25);
    const TriangleDistance touching = triangle_distance(kBase, {Vec3(1, 1, 0), Vec3(1, 1, 2), Vec3(9, 9, 2)});
    EXPECT_EQ(touching.distance, 0.0);
    EXPECT_EQ(touching.depth, 0.0);
    const TriangleDistance coplanar = triangle_distance(kBase, {Vec3(1, 1, 0), Vec3(5, 1, 0), Vec3(1, 5, 0)});
    EXPECT_EQ(coplanar.distance, 0.0);
    EXPECT_EQ(coplanar.depth, 0.0);
}

TEST(TriangleDistance, IsNoMoreThanThatOfSamplesAndReached) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    const auto point = [&] { return Vec3(real(random), real(random), real(random)); };
    for (int round = 0; round < 200; ++round) {
        const Corners a{point(), point(), point()};
        Corners b{point(), point(), point()};
        for (Vec3& p : b) {
            p.x() += 1.0;
        }
        const TriangleDistance found = triangle_distance(a, b);
        EXPECT_NEAR((found.on_first - found.on_second).norm(), found.distance, 1e-14);
        constexpr int kSamples = 12;
        double sampled = 1e9;
        for (int i = 0; i <= kSamples; ++i) {
            for (int j = 0; i + j <= kSamples; ++j) {
                const double u = double(i) / kSamples, v = double(j) / kSamples;
                const Vec3 p = (1 - u - v) * a[0] + u * a[1] + v * a[2];
                for (int k = 0; k <= kSamples; ++k) {
                    for (int l = 0; k + l <= kSamples; ++l) {
                        const double s = double(k) / kSamples, t = double(l) / kSamples;
                        sampled = std::min(sampled, (p - ((1 - s - t) * b[0] + s * b[1] + t * b[2])).norm());
                    }
                }
            }
        }
        EXPECT_LE(found.distance, sampled + 1e-12);
        EXPECT_GE(found.distance, sampled - 0.5);
    }
}

TEST(TriangleDistance, NearestOnATriangleIsNearerThanItsSamples) {
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    const auto point = [&] { return Vec3(real(random), real(random), real(random)); };
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = point();
        const Vec3 b = point();
        const Vec3 c = point();
        const Vec3 p = 2.0 * point();
        const double found = (nearest_on_triangle(p, a, b, c) - p).norm();
        // Samples along each side of the triangle.
        constexpr int kSamples = 12;
        for (int u = 0; u <= kSamples; ++u) {
            for (int v = 0; u + v <= kSamples; ++v) {
                const Vec3 sample = a + (b - a) * u / kSamples + (c - a) * v / kSamples;
                ASSERT_LE(found, (sample - p).norm() + 1e-12);
            }
        }
    }
}

}  // namespace
}  // namespace mq::mesh
