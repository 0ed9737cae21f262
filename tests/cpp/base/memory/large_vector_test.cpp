// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/memory/large_vector.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace {

using mq::LargeVector;

/// Over the sizes from which memory comes in blocks, and in large pages.
TEST(LargeVector, KeepsItsValuesWhileItGrowsAndShrinks) {
    constexpr std::uint32_t kCount = 5'000'000;
    LargeVector<std::uint32_t> values;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        values.push_back(i);
    }
    values.resize(kCount / 100);
    values.shrink_to_fit();
    EXPECT_EQ(values.capacity(), values.size());
    LargeVector<std::uint32_t> others(kCount, 7);
    others.swap(values);
    ASSERT_EQ(others.size(), kCount / 100);
    for (std::uint32_t i = 0; i < others.size(); ++i) {
        ASSERT_EQ(others[i], i);
    }
    EXPECT_EQ(values.back(), 7U);
}

}  // namespace
