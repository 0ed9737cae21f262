// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <tsl/robin_map.h>
#include <tsl/robin_set.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace mq {

/// The one hash of keys: spreads those that differ only in their low bits over all bits (Fibonacci hashing).
struct KeyHash {
    std::size_t operator()(std::uint64_t key) const {
        key *= 0x9E3779B97F4A7C15ULL;
        return key ^ (key >> 32);
    }
    /// The hash of indices in this order.
    template <std::size_t N>
    std::size_t operator()(const std::array<std::int32_t, N>& key) const {
        std::uint64_t hash = 0;
        for (const std::int32_t index : key) {
            hash = operator()(hash ^ static_cast<std::uint32_t>(index));
        }
        return hash;
    }
};

/// Sets and maps of 64-bit keys in one block of memory: built, searched and freed several times faster than with nodes.
using KeySet = tsl::robin_set<std::uint64_t, KeyHash>;
template <typename Value>
using KeyMap = tsl::robin_map<std::uint64_t, Value, KeyHash>;

/// The key of two numbers in this order.
inline std::uint64_t ordered_key(std::uint32_t first, std::uint32_t second) {
    return (static_cast<std::uint64_t>(first) << 32) | second;
}

/// The key of two indices, at least 0, in either order.
inline std::uint64_t pair_key(std::int32_t a, std::int32_t b) {
    return ordered_key(static_cast<std::uint32_t>(std::min(a, b)), static_cast<std::uint32_t>(std::max(a, b)));
}

}  // namespace mq
