// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "base/system/system.h"

namespace mq {

/// An allocator that uses allocate_block for arrays of 1 MB and more. Smaller arrays are allocated and freed often: the
/// system would clear their pages each time.
template <typename Value>
struct BlockAllocator {
    using value_type = Value;
    static constexpr std::size_t kLarge = std::size_t{1} << 20;

    BlockAllocator() = default;
    template <typename Other>
    BlockAllocator(const BlockAllocator<Other>& /*other*/) noexcept {}

    Value* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(Value);
        return static_cast<Value*>(bytes < kLarge ? ::operator new(bytes) : allocate_block(bytes));
    }
    void deallocate(Value* values, std::size_t count) noexcept {
        const std::size_t bytes = count * sizeof(Value);
        if (bytes < kLarge) {
            ::operator delete(values);
        } else {
            free_block(values, bytes);
        }
    }
    template <typename Other>
    bool operator==(const BlockAllocator<Other>& /*other*/) const noexcept {
        return true;
    }
    template <typename Other>
    bool operator!=(const BlockAllocator<Other>& /*other*/) const noexcept {
        return false;
    }
};

/// A vector for data by vertex, edge or triangle.
template <typename Value>
using LargeVector = std::vector<Value, BlockAllocator<Value>>;

}  // namespace mq
