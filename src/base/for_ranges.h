// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/parallel.h"

namespace mq {

/// Items in a range: about 20 µs of work or more.
constexpr std::size_t kItemsInRange = 8192;

/// Calls work(from, to) for ranges that make up 0 .. count - 1, in parallel and in no particular order: for loops over
/// large arrays, which take nanoseconds for an item. Ranges depend on `count` alone.
/// @throws as parallel_for
template <typename Work>
void for_ranges(std::size_t count, const Work& work) {
    const ThreadLimit limit(threads_for(count, 2 * kItemsInRange));
    parallel_for(static_cast<int>((count + kItemsInRange - 1) / kItemsInRange), [&](int k) {
        const std::size_t from = static_cast<std::size_t>(k) * kItemsInRange;
        work(from, std::min(from + kItemsInRange, count));
    });
}

/// Calls work(item) for 0 .. count - 1, as for_ranges does.
template <typename Work>
void for_each_in_ranges(std::size_t count, const Work& work) {
    for_ranges(count, [&](std::size_t from, std::size_t to) {
        for (std::size_t item = from; item < to; ++item) {
            work(item);
        }
    });
}

/// Returns the items that work(from, to, found) adds to `found`, in the order of the ranges.
template <typename Items, typename Work>
Items found_in_ranges(std::size_t count, const Work& work) {
    std::vector<Items> of_ranges((count + kItemsInRange - 1) / kItemsInRange);
    for_ranges(count, [&](std::size_t from, std::size_t to) { work(from, to, of_ranges[from / kItemsInRange]); });
    Items all;
    for (Items& of_range : of_ranges) {
        all.insert(all.end(), of_range.begin(), of_range.end());
        of_range = {};
    }
    return all;
}

}  // namespace mq
