// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <numeric>
#include <vector>

#include "base/for_ranges.h"

namespace mq::mesh {

/// Gives indices that are not known (-1) numbers from `first` on, in the order in which index_at(0 .. count - 1) has
/// them. Several threads do what one thread would: each index belongs to the first range with it, and every range
/// numbers its own.
/// @return  the number after the last one
template <typename IndexAt, typename Indices>
int number_by_first_use(std::size_t count, const IndexAt& index_at, int first, Indices& indices) {
    if (threads_for(count, 2 * kItemsInRange) == 1) {
        for (std::size_t i = 0; i < count; ++i) {
            int& index = indices[index_at(i)];
            index = index < 0 ? first++ : index;
        }
        return first;
    }
    std::vector<std::atomic<int>> owners(indices.size());
    const auto ranges = static_cast<int>((count + kItemsInRange - 1) / kItemsInRange);
    for_each_in_ranges(owners.size(), [&](std::size_t i) { owners[i].store(ranges, std::memory_order_relaxed); });
    for_ranges(count, [&](std::size_t from, std::size_t to) {
        const auto range = static_cast<int>(from / kItemsInRange);
        for (std::size_t i = from; i < to; ++i) {
            std::atomic<int>& owner = owners[static_cast<std::size_t>(index_at(i))];
            int known = owner.load(std::memory_order_relaxed);
            while (range < known && !owner.compare_exchange_weak(known, range, std::memory_order_relaxed)) {
            }
        }
    });
    std::vector<int> starts(static_cast<std::size_t>(ranges) + 1, 0);
    for_ranges(count, [&](std::size_t from, std::size_t to) {  // numbers within the range, below -1
        const auto range = static_cast<int>(from / kItemsInRange);
        int here = 0;
        for (std::size_t i = from; i < to; ++i) {
            const auto index = static_cast<std::size_t>(index_at(i));
            if (owners[index].load(std::memory_order_relaxed) == range && indices[index] == -1) {
                indices[index] = -2 - here++;
            }
        }
        starts[static_cast<std::size_t>(range) + 1] = here;
    });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    for_each_in_ranges(indices.size(), [&](std::size_t i) {
        if (indices[i] < -1) {
            indices[i] =
                first + starts[static_cast<std::size_t>(owners[i].load(std::memory_order_relaxed))] - 2 - indices[i];
        }
    });
    return first + starts.back();
}

}  // namespace mq::mesh
