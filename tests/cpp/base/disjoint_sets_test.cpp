// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/disjoint_sets.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace {

using mq::DisjointSets;

TEST(DisjointSets, TheRootIsTheLowestMember) {
    DisjointSets<std::int32_t> sets(6);
    sets.unite(5, 4);
    sets.unite(4, 2);
    EXPECT_EQ(sets.find(5), 2);
    EXPECT_EQ(sets.find(4), 2);
    EXPECT_EQ(sets.find(3), 3);
}

TEST(DisjointSets, NumbersSetsInTheOrderOfTheirLowestMembers) {
    DisjointSets<std::int32_t> sets(6);
    sets.unite(1, 5);
    sets.unite(4, 2);
    std::int32_t count = -1;
    EXPECT_EQ(sets.number(count), (std::vector<std::int32_t>{0, 1, 2, 3, 2, 1}));
    EXPECT_EQ(count, 4);
}

TEST(DisjointSets, MembersThatWereResetAreAlone) {
    DisjointSets<std::int32_t> sets(4);
    sets.unite(0, 1);
    sets.unite(2, 3);
    sets.reset(0);
    sets.reset(1);
    EXPECT_EQ(sets.find(1), 1);
    EXPECT_EQ(sets.find(3), 2);
}

TEST(DisjointSets, AgreesWithRelabellingWhateverTheOrder) {
    std::mt19937 random(7);
    // Members of the sets.
    constexpr std::uint32_t kCount = 60;
    DisjointSets<std::uint32_t> sets(kCount);
    std::vector<std::uint32_t> label(kCount);
    for (std::uint32_t i = 0; i < kCount; ++i) {
        label[i] = i;
    }
    for (int step = 0; step < 45; ++step) {
        const std::uint32_t a = random() % kCount;
        const std::uint32_t b = random() % kCount;
        sets.unite(a, b);
        const std::uint32_t low = std::min(label[a], label[b]);
        const std::uint32_t high = std::max(label[a], label[b]);
        std::replace(label.begin(), label.end(), high, low);
        for (std::uint32_t i = 0; i < kCount; ++i) {
            ASSERT_EQ(sets.find(i), label[i]);
        }
    }
}

}  // namespace
