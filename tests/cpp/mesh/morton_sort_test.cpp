// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/morton_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

namespace mq::mesh {
namespace {

TEST(MortonCode, InterleavesTheBitsOfTheCells) {
    EXPECT_EQ(morton_code({0.0, 0.0, 0.0}), 0U);
    EXPECT_EQ(morton_code({0.9, 0.0, 1.5}), 1U);
    EXPECT_EQ(morton_code({0.0, 1.0, 0.0}), 2U);
    EXPECT_EQ(morton_code({1.0, 0.0, 0.0}), 4U);
    EXPECT_EQ(morton_code({2.0, 0.0, 0.0}), 32U);
    const double last = kMortonCells - 1;
    EXPECT_EQ(morton_code({last, last, last}), (1U << 30) - 1);
}

TEST(MortonCode, TakesWhatIsNoNumberForZero) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(morton_code({none, -3.0, 1.0}), 1U);
}

TEST(MortonSort, IsThatOfTheStandardLibraryAndStable) {
    std::mt19937 engine(3);
    for (const std::uint32_t most : {5U, 5000U, (1U << 30) - 1}) {
        std::uniform_int_distribution<std::uint32_t> any(0, most);
        LargeVector<MortonKey> keys(3000);
        for (std::size_t i = 0; i < keys.size(); ++i) {
            keys[i] = {any(engine), static_cast<std::uint32_t>(i)};
        }
        LargeVector<MortonKey> expected = keys;
        std::stable_sort(expected.begin(), expected.end(),
                         [](const MortonKey& a, const MortonKey& b) { return a.code < b.code; });
        sort_by_code(keys);
        for (std::size_t i = 0; i < keys.size(); ++i) {
            ASSERT_EQ(std::tie(keys[i].code, keys[i].item), std::tie(expected[i].code, expected[i].item));
        }
    }
    LargeVector<MortonKey> none;
    sort_by_code(none);
    EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace mq::mesh
