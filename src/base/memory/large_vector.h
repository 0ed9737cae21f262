// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace mq {

/// Memory for large arrays, in blocks of the system's: given back as soon as it is freed, whereas an allocator may keep
/// it. Blocks of 16 MB and more are in large pages where the system has them, which makes random access faster.
/// @throws std::bad_alloc
void* allocate_block(std::size_t bytes);
/// Gives a block back; `bytes` as when it was taken.
void free_block(void* block, std::size_t bytes) noexcept;
/// Returns freed memory that the allocator keeps to the system, so that the following work can use it.
void release_freed_memory();

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
