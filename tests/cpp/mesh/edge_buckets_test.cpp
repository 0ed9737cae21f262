// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/edge_buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <tuple>

namespace mq::mesh {
namespace {

using Row = std::tuple<std::int32_t, std::int32_t, std::uint32_t, bool>;  // low, high, corner, way

std::vector<Triangle> random_soup(std::size_t triangles, std::int32_t vertices) {
    std::mt19937 engine(7);
    std::uniform_int_distribution<std::int32_t> any(0, vertices - 1);
    std::vector<Triangle> soup(triangles);
    for (Triangle& t : soup) {
        t = {any(engine), any(engine), any(engine)};
    }
    return soup;
}

std::vector<Row> rows_of(const EdgeBuckets& buckets) {
    std::vector<Row> rows;
    for (std::size_t v = 0; v + 1 < buckets.begin.size(); ++v) {
        for (std::size_t i = buckets.begin[v]; i < buckets.begin[v + 1]; ++i) {
            const EdgeEntry& entry = buckets.entries[i];
            rows.emplace_back(static_cast<std::int32_t>(v), entry.high, entry.corner(), entry.upward());
        }
    }
    return rows;
}

std::vector<Row> rows_by_sorting(const std::vector<Triangle>& soup) {
    std::vector<Row> rows;
    for (std::size_t k = 0; k < soup.size(); ++k) {
        for (std::size_t i = 0; i < 3 && !is_collapsed(soup[k]); ++i) {
            const auto [low, high] = std::minmax(soup[k][i], soup[k][(i + 1) % 3]);
            rows.emplace_back(low, high, static_cast<std::uint32_t>(3 * k + i), soup[k][i] == low);
        }
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

TEST(EdgeBuckets, AreTheSameForAnyNumberOfThreads) {
    const std::vector<Triangle> soup = random_soup(150'000, 40'000);
    const std::vector<Row> wanted = rows_by_sorting(soup);
    for (const int threads : {1, 2, 3, 8}) {
        const ThreadLimit limit(threads);
        std::atomic<std::size_t> visited{0};
        const EdgeBuckets buckets =
            edge_buckets(soup, 40'000, [&](const EdgeEntry* first, const EdgeEntry* last) { visited += last - first; });
        EXPECT_EQ(rows_of(buckets), wanted) << threads << " threads";
        EXPECT_EQ(visited, wanted.size());
    }
}

TEST(EdgeBuckets, LargeBucketsAreSortedToo) {
    std::vector<Triangle> fan;
    for (std::int32_t i = 100; i > 1; --i) {
        fan.push_back({0, i, i - 1});
    }
    fan.push_back({0, 0, 1});  // collapsed: left out
    EXPECT_EQ(rows_of(edge_buckets(fan, 101, [](const EdgeEntry*, const EdgeEntry*) {})), rows_by_sorting(fan));
}

TEST(EdgeBuckets, NoTrianglesHaveNoEdges) {
    EXPECT_TRUE(edge_buckets({}, 0, [](const EdgeEntry*, const EdgeEntry*) {}).entries.empty());
    EXPECT_EQ(edge_buckets({}, 5, [](const EdgeEntry*, const EdgeEntry*) {}).begin.size(), 6u);
}

}  // namespace
}  // namespace mq::mesh
