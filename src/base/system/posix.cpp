// SPDX-License-Identifier: LGPL-2.1-or-later
#include <dlfcn.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <initializer_list>
#include <new>

#include "base/system/system.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace mq {

double cpu_seconds() {
    double sum = 0.0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(who, &usage);
        for (const timeval& t : {usage.ru_utime, usage.ru_stime}) {
            sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
        }
    }
    return sum;
}

void* allocate_block(std::size_t bytes) {
    void* const block = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED) {
        throw std::bad_alloc();
    }
#ifdef MADV_HUGEPAGE
    // Smaller blocks would waste a large fraction of their last page, as large pages have 2 MB.
    constexpr std::size_t kWorthLargePages = std::size_t{1} << 24;
    if (bytes >= kWorthLargePages) {
        madvise(block, bytes, MADV_HUGEPAGE);  // advice only: if it fails, pages are small
    }
#endif
    return block;
}

void free_block(void* block, std::size_t bytes) noexcept {
    munmap(block, bytes);
}

void release_freed_memory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

void at_fork(void (*before)(), void (*in_parent)(), void (*in_child)()) {
    pthread_atfork(before, in_parent, in_child);
}

void at_exit(void (*call)()) {
    std::atexit(call);
}

void at_thread_end(void (*call)()) {
    struct ThreadEnd {
        void (*call)();
        ~ThreadEnd() { call(); }
    };
    thread_local const ThreadEnd end{call};
}

void skip_destructors() {
#ifdef __GLIBC__
    on_exit(
        [](int status, void* /*argument*/) {
            std::fflush(nullptr);
            _exit(status);
        },
        nullptr);
#endif
}

std::FILE* open_for_writing(const std::string& path) {
    return std::fopen(path.c_str(), "wb");
}

void* symbol_of_library(const std::string& path, const char* name) {
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_NOLOAD);
    return library == nullptr ? nullptr : dlsym(library, name);
}

}  // namespace mq
