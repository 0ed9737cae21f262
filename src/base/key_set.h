// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <tsl/robin_map.h>
#include <tsl/robin_set.h>

#include <cstddef>
#include <cstdint>

namespace mq {

/// Spreads keys whose low bits alone are alike over all bits (Fibonacci hashing).
struct KeyHash {
    std::size_t operator()(std::uint64_t key) const {
        key *= 0x9E3779B97F4A7C15ULL;
        return key ^ (key >> 32);
    }
};

/// Sets and maps of 64-bit keys in one piece of memory: made, searched and freed several times faster than with nodes.
using KeySet = tsl::robin_set<std::uint64_t, KeyHash>;
template <typename Value>
using KeyMap = tsl::robin_map<std::uint64_t, Value, KeyHash>;

}  // namespace mq
