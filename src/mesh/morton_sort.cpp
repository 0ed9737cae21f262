// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/morton_sort.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "base/for_ranges.h"

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
    using Counts = std::array<std::uint32_t, kBuckets>;
    LargeVector<MortonKey> sorted(keys.size());
    std::vector<Counts> places((keys.size() + kItemsInRange - 1) / kItemsInRange);  // by range of keys
    for (int pass = 0; pass < kPasses; ++pass) {
        const auto bucket = [&](const MortonKey& key) { return (key.code >> (kBits * pass)) & (kBuckets - 1); };
        for_ranges(keys.size(), [&](std::size_t from, std::size_t to) {
            Counts& counts = places[from / kItemsInRange];
            counts.fill(0);
            for (std::size_t i = from; i < to; ++i) {
                ++counts[bucket(keys[i])];
            }
        });
        std::uint32_t place = 0;
        for (std::size_t b = 0; b < kBuckets; ++b) {
            for (Counts& counts : places) {
                place += std::exchange(counts[b], place);
            }
        }
        for_ranges(keys.size(), [&](std::size_t from, std::size_t to) {
            Counts& next = places[from / kItemsInRange];
            for (std::size_t i = from; i < to; ++i) {
                sorted[next[bucket(keys[i])]++] = keys[i];
            }
        });
        keys.swap(sorted);
    }
}

}  // namespace mq::mesh
