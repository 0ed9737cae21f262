// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/memory/large_vector.h"

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace mq {

#ifdef __linux__

void* allocate_block(std::size_t bytes) {
    // Smaller blocks would waste a large fraction of their last page, as large pages have 2 MB.
    constexpr std::size_t kWorthLargePages = std::size_t{1} << 24;
    void* block = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED) {
        throw std::bad_alloc();
    }
    if (bytes >= kWorthLargePages) {
        madvise(block, bytes, MADV_HUGEPAGE);  // advice only: if it fails, pages are small
    }
    return block;
}

void free_block(void* block, std::size_t bytes) noexcept {
    munmap(block, bytes);
}

#else

void* allocate_block(std::size_t bytes) {
    return ::operator new(bytes);
}

void free_block(void* block, std::size_t /*bytes*/) noexcept {
    ::operator delete(block);
}

#endif

void release_freed_memory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace mq
