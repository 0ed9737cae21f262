// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/vertex_clustering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "base/error.h"

namespace mq::mesh {
namespace {

/// A torus with the given number of rings.
std::vector<float> torus(int rings) {
    std::vector<float> corners;
    const auto add = [&](int i, int k) {
        const double u = 2.0 * M_PI * i / (3 * rings), v = 2.0 * M_PI * k / rings;
        for (const double x :
             {(5.0 + 2.0 * std::cos(v)) * std::cos(u), (5.0 + 2.0 * std::cos(v)) * std::sin(u), 2.0 * std::sin(v)}) {
            corners.push_back(static_cast<float>(x));
        }
    };
    for (int i = 0; i < 3 * rings; ++i) {
        for (int k = 0; k < rings; ++k) {
            add(i, k), add(i + 1, k), add(i + 1, k + 1);
            add(i, k), add(i + 1, k + 1), add(i, k + 1);
        }
    }
    return corners;
}

TEST(Cluster, KeepsAboutAsManyAsWantedNearTheSurface) {
    const std::vector<float> fine = torus(200);
    const std::size_t triangles = fine.size() / 9;
    for (const std::size_t wanted : {2000U, 10000U}) {
        const ClusteredMesh coarse = cluster(fine.data(), triangles, wanted);
        const double count = static_cast<double>(coarse.corners.size()) / 9.0;
        EXPECT_GT(count, 0.3 * static_cast<double>(wanted));
        EXPECT_LT(count, 3.0 * static_cast<double>(wanted));
        const double cell = std::sqrt(2.0 * 4.0 * M_PI * M_PI * 10.0 / static_cast<double>(wanted));
        for (std::size_t k = 0; k < coarse.corners.size(); k += 3) {
            const double ring = std::hypot(coarse.corners[k], coarse.corners[k + 1]) - 5.0;
            EXPECT_NEAR(std::hypot(ring, coarse.corners[k + 2]), 2.0, cell);
        }
    }
}

TEST(Cluster, LeavesOutTrianglesThatAreNotFinite) {
    for (const float odd : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        std::vector<float> fine = torus(20);
        fine.insert(fine.begin(), {odd, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F});
        const ClusteredMesh coarse = cluster(fine.data(), fine.size() / 9, 100);
        EXPECT_EQ(coarse.joined[0], -1);
        EXPECT_FALSE(coarse.corners.empty());
        EXPECT_TRUE(
            std::all_of(coarse.corners.begin(), coarse.corners.end(), [](float x) { return std::isfinite(x); }));
        const ClusteredMesh none = cluster(fine.data(), 1, 100);
        EXPECT_TRUE(none.corners.empty());
        EXPECT_EQ(none.joined, std::vector<std::int32_t>{-1});
    }
}

TEST(Cluster, TellsWhatStandsForEachTriangle) {
    const std::vector<float> fine = torus(100);
    const ClusteredMesh coarse = cluster(fine.data(), fine.size() / 9, 3000);
    ASSERT_EQ(coarse.joined.size(), fine.size() / 9);
    std::set<std::int32_t> used;
    for (std::size_t t = 0; t < coarse.joined.size(); ++t) {
        if (coarse.joined[t] >= 0) {
            used.insert(coarse.joined[t]);
            const float* a = &fine[9 * t];
            const float* b = &coarse.corners[9 * static_cast<std::size_t>(coarse.joined[t])];
            EXPECT_LT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 2.0);
        }
    }
    EXPECT_EQ(used.size(), coarse.corners.size() / 9);
}

TEST(Cluster, OfAFewTrianglesThatLieFarApartAllStay) {
    const std::vector<float> corners{0, 0, 0, 10, 0, 0, 0, 10, 0, 100, 0, 0, 110, 0, 0, 100, 10, 0};
    const ClusteredMesh coarse = cluster(corners.data(), 2, 1000);
    EXPECT_EQ(coarse.corners.size(), corners.size());
    EXPECT_EQ(cluster(nullptr, 0, 1000).corners.size(), 0U);
    // Points that lie all in one place have no area and no extent.
    const std::vector<float> points(9, 3.0F);
    EXPECT_EQ(cluster(points.data(), 1, 1000).joined, std::vector<std::int32_t>{-1});
    Progress progress;
    progress.cancel();
    EXPECT_THROW(cluster(corners.data(), 2, 1000, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::mesh
