// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/aabb_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "mesh/intersection/triangle_soup.h"

namespace mq::mesh {
namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

bool meet(const Box& a, const Box& b) {
    return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// The box, widened by the rounding to single precision.
Box widened(Box box) {
    for (int i = 0; i < 3; ++i) {
        box.low[i] -= 2e-7 * std::abs(box.low[i]) + 1e-40;
        box.high[i] += 2e-7 * std::abs(box.high[i]) + 1e-40;
    }
    return box;
}

/// All of `exact` were reported, nothing twice, and nothing that is not in `rounded`.
template <typename T>
void expect_between(const std::vector<T>& reported, const std::set<T>& exact, const std::set<T>& rounded) {
    const std::set<T> found(reported.begin(), reported.end());
    EXPECT_EQ(found.size(), reported.size());
    EXPECT_TRUE(std::includes(found.begin(), found.end(), exact.begin(), exact.end()));
    EXPECT_TRUE(std::includes(rounded.begin(), rounded.end(), found.begin(), found.end()));
}

class TriangleTreeTest : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Soups, TriangleTreeTest, testing::Range(0, int(Soup::kKinds)));

TEST_P(TriangleTreeTest, FindsThePairsOfTwoTrees) {
    const Soup a(GetParam(), 157, 1);
    const Soup b(GetParam(), 61, 2);
    const AabbTree tree_a(a.vertices, a.triangles);
    const AabbTree tree_b(b.vertices, b.triangles);
    std::vector<Pair> found;
    tree_a.for_each_pair(tree_b, [&](std::int32_t i, std::int32_t j) { found.emplace_back(i, j); });
    std::set<Pair> exact;
    std::set<Pair> rounded;
    for (std::int32_t i = 0; i < 157; ++i) {
        for (std::int32_t j = 0; j < 61; ++j) {
            if (meet(a.box(i), b.box(j))) {
                exact.emplace(i, j);
            }
            if (meet(widened(a.box(i)), widened(b.box(j)))) {
                rounded.emplace(i, j);
            }
        }
    }
    expect_between(found, exact, rounded);
}

TEST_P(TriangleTreeTest, FindsItsOwnPairsOnce) {
    const Soup soup(GetParam(), 143, 3);
    const AabbTree tree(soup.vertices, soup.triangles);
    std::vector<Pair> found;
    tree.for_each_own_pair([&](std::int32_t i, std::int32_t j) { found.emplace_back(std::minmax(i, j)); });
    std::set<Pair> exact;
    std::set<Pair> rounded;
    for (std::int32_t i = 0; i < 143; ++i) {
        for (std::int32_t j = i + 1; j < 143; ++j) {
            if (meet(soup.box(i), soup.box(j))) {
                exact.emplace(i, j);
            }
            if (meet(widened(soup.box(i)), widened(soup.box(j)))) {
                rounded.emplace(i, j);
            }
        }
    }
    expect_between(found, exact, rounded);
}

TEST_P(TriangleTreeTest, TasksGiveTheSamePairs) {
    const Soup soup(GetParam(), 400, 4);
    const AabbTree tree(soup.vertices, soup.triangles);
    std::vector<Pair> whole;
    tree.for_each_own_pair([&](std::int32_t i, std::int32_t j) { whole.emplace_back(i, j); });
    std::vector<Pair> parts;
    const std::vector<AabbTree::Task> tasks = tree.own_pair_tasks(20);
    EXPECT_GE(tasks.size(), 10u);
    for (const AabbTree::Task& task : tasks) {
        tree.for_each_own_pair(task, [&](std::int32_t i, std::int32_t j) { parts.emplace_back(i, j); });
    }
    std::sort(whole.begin(), whole.end());
    std::sort(parts.begin(), parts.end());
    EXPECT_FALSE(whole.empty());
    EXPECT_EQ(parts, whole);
}

TEST(AabbTree, NoTaskHasMostPairsWhereTwoSheetsLieOnEachOther) {
    constexpr int kSide = 40;
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (int sheet = 0; sheet < 2; ++sheet) {
        const auto first = static_cast<std::int32_t>(vertices.size());
        for (int i = 0; i <= kSide; ++i) {
            for (int j = 0; j <= kSide; ++j) {
                vertices.emplace_back(i, j, 0.0);
            }
        }
        for (std::int32_t i = 0; i < kSide * (kSide + 1); ++i) {
            if (i % (kSide + 1) < kSide) {
                triangles.push_back({first + i, first + i + kSide + 1, first + i + 1});
                triangles.push_back({first + i + 1, first + i + kSide + 1, first + i + kSide + 2});
            }
        }
    }
    AabbTree tree(vertices, triangles);
    // No pairs within a sheet: they meet at the divisions of the tree only.
    std::vector<std::int32_t> sheet_of(triangles.size(), 0);
    std::fill(sheet_of.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2), sheet_of.end(), 1);
    tree.set_groups(sheet_of);
    std::size_t all = 0;
    std::size_t most = 0;
    for (const AabbTree::Task& task : tree.own_pair_tasks(64)) {
        std::size_t pairs = 0;
        tree.for_each_own_pair(task, [&](std::int32_t, std::int32_t) { ++pairs; });
        all += pairs;
        most = std::max(most, pairs);
    }
    EXPECT_GT(all, triangles.size());
    EXPECT_LT(16 * most, all);
}

TEST_P(TriangleTreeTest, FindsWhatMeetsABox) {
    const Soup soup(GetParam(), 300, 6);
    const Soup queries(GetParam(), 40, 7);
    const AabbTree tree(soup.vertices, soup.triangles);
    for (std::int32_t q = 0; q < 40; ++q) {
        std::vector<std::int32_t> found;
        tree.for_each_in_box(queries.box(q), [&](std::int32_t i) { found.push_back(i); });
        std::set<std::int32_t> exact;
        std::set<std::int32_t> rounded;
        for (std::int32_t i = 0; i < 300; ++i) {
            if (meet(soup.box(i), queries.box(q))) {
                exact.insert(i);
            }
            if (meet(widened(soup.box(i)), widened(queries.box(q)))) {
                rounded.insert(i);
            }
        }
        expect_between(found, exact, rounded);
    }
}

TEST(AabbTree, AVisitMayEndTheSearch) {
    const Soup soup(Soup::kRandom, 100, 15);
    const AabbTree tree(soup.vertices, soup.triangles);
    int visited = 0;
    tree.for_each_in_box(tree.box(), [&](std::int32_t) { return ++visited < 7; });
    EXPECT_EQ(visited, 7);
}

TEST_P(TriangleTreeTest, ARayMissesNoTriangleItHits) {
    const Soup soup(GetParam(), 300, 8);
    const AabbTree tree(soup.vertices, soup.triangles);
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    for (std::int32_t i = 0; i < 300; ++i) {
        // From the triangle's middle or a corner backwards, so that the ray meets it at t = 1.
        Vec3 direction(real(random), real(random), real(random));
        if (i % 3 == 0) {
            direction = Vec3::Unit(i % 9 / 3);
        }
        const Triangle& t = soup.triangles[i];
        const Vec3 target =
            i % 2 == 0 ? soup.vertices[t[0]] : (soup.vertices[t[0]] + soup.vertices[t[1]] + soup.vertices[t[2]]) / 3.0;
        const Vec3 origin = target - direction;
        int hits = 0;
        tree.for_each_on_ray(target, direction, [&](std::int32_t k) { hits += k == i; });
        EXPECT_EQ(hits, 1) << "starting at triangle " << i;
        // An origin that is rounded makes the ray pass a flat box by a rounding.
        if (GetParam() == Soup::kRandom) {
            hits = 0;
            tree.for_each_on_ray(origin, direction, 1.0 + 1e-12, [&](std::int32_t k) { hits += k == i; });
            EXPECT_EQ(hits, 1) << "ending at triangle " << i;
        }
    }
}

TEST(AabbTree, ARayPassesByWhatItDoesNotMeet) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 5}, {1, 0, 5}, {0, 1, 5}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}};
    const AabbTree tree(vertices, triangles);
    const auto hits = [&](const Vec3& origin, const Vec3& direction, double reach) {
        std::vector<std::int32_t> found;
        tree.for_each_on_ray(origin, direction, reach, [&](std::int32_t i) { found.push_back(i); });
        std::sort(found.begin(), found.end());
        return found;
    };
    using Found = std::vector<std::int32_t>;
    EXPECT_EQ(hits({0.2, 0.2, -1}, {0, 0, 1}, 10.0), (Found{0, 1}));
    EXPECT_EQ(hits({0.2, 0.2, -1}, {0, 0, 1}, 3.0), (Found{0}));
    EXPECT_EQ(hits({0.2, 0.2, 1}, {0, 0, 1}, 10.0), (Found{1}));
    EXPECT_EQ(hits({0.2, 0.2, 1}, {0, 0, -1}, 10.0), (Found{0}));
    EXPECT_EQ(hits({1.5, 0.2, -1}, {0, 0, 1}, 10.0), (Found{}));
    EXPECT_EQ(hits({-1, 0.5, 0}, {1, 0, 0}, 10.0), (Found{0}));
    EXPECT_EQ(hits({-1, 0.5, 5}, {1, 0, 1e-3}, 10.0), (Found{}));
}

TEST_P(TriangleTreeTest, ASubsetIsATreeOfItsOwn) {
    const Soup soup(GetParam(), 200, 13);
    std::vector<std::int32_t> odd;
    for (std::int32_t i = 1; i < 200; i += 2) {
        odd.push_back(i);
    }
    const AabbTree tree(soup.vertices, soup.triangles, odd);
    EXPECT_EQ(tree.size(), odd.size());
    std::vector<std::int32_t> found;
    tree.for_each_in_box(tree.box(), [&](std::int32_t i) { found.push_back(i); });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, odd);
}

TEST(AabbTree, NothingIsFoundInAnEmptyTree) {
    const std::vector<Vec3> vertices;
    const std::vector<Triangle> triangles;
    const AabbTree tree(vertices, triangles);
    const auto fail = [](auto...) { ADD_FAILURE(); };
    EXPECT_TRUE(tree.box().empty());
    EXPECT_TRUE(tree.own_pair_tasks(4).empty());
    tree.for_each_pair(tree, fail);
    tree.for_each_own_pair(fail);
    tree.for_each_in_box(Box{Vec3(-1, -1, -1), Vec3(1, 1, 1)}, fail);
    tree.for_each_on_ray(Vec3(0, 0, 0), Vec3(1, 0, 0), fail);
}

/// Boxes in single precision have no ends there; nothing is missed.
TEST(AabbTree, MissesNothingBeyondSinglePrecision) {
    for (const double size : {1e39, 1e120}) {
        Soup soup(Soup::kRandom, 60, 5);
        for (Vec3& p : soup.vertices) {
            p *= size;
        }
        const AabbTree tree(soup.vertices, soup.triangles);
        std::set<Pair> found;
        tree.for_each_own_pair([&](std::int32_t i, std::int32_t j) { found.emplace(std::min(i, j), std::max(i, j)); });
        for (std::int32_t i = 0; i < 60; ++i) {
            for (std::int32_t j = i + 1; j < 60; ++j) {
                EXPECT_TRUE(found.count({i, j}) > 0 || !meet(soup.box(i), soup.box(j)));
            }
        }
    }
}

}  // namespace
}  // namespace mq::mesh
