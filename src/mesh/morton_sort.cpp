// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/morton_sort.h"

#include <cstddef>
#include <numeric>

namespace mq::mesh {

namespace {

// The ten lowest bits, each followed by two zeros.
std::uint32_t spread(std::uint32_t x) {
    x = (x | (x << 16)) & 0x030000ffu;
    x = (x | (x << 8)) & 0x0300f00fu;
    x = (x | (x << 4)) & 0x030c30c3u;
    return (x | (x << 2)) & 0x09249249u;
}

}  // namespace

std::uint32_t morton_code(const std::array<double, 3>& cell) {
    std::uint32_t code = 0;
    for (const double place : cell) {
        code = (code << 1) | spread(place > 0.0 ? static_cast<std::uint32_t>(place) : 0U);
    }
    return code;
}

void sort_by_code(LargeVector<MortonKey>& keys) {
    // Bits of the code along one axis, which are also the digits of one pass of the radix sort.
    constexpr int kBits = 10;
    constexpr int kPasses = 3;
    // Buckets of one pass.
    constexpr std::size_t kBuckets = std::size_t{1} << kBits;
    std::array<std::array<std::uint32_t, kBuckets + 1>, kPasses> begin{};
    for (const MortonKey& key : keys) {
        for (int pass = 0; pass < kPasses; ++pass) {
            ++begin[pass][((key.code >> (kBits * pass)) & (kBuckets - 1)) + 1];
        }
    }
    LargeVector<MortonKey> sorted(keys.size());
    for (int pass = 0; pass < kPasses; ++pass) {
        std::partial_sum(begin[pass].begin(), begin[pass].end(), begin[pass].begin());
        for (const MortonKey& key : keys) {
            sorted[begin[pass][(key.code >> (kBits * pass)) & (kBuckets - 1)]++] = key;
        }
        keys.swap(sorted);
    }
}

}  // namespace mq::mesh
