// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "base/system/system.h"
#include "base/threads/kept_threads.h"

namespace mq {
namespace {

/// The exit status of a fork that ends with what `status` returns in it.
template <typename Status>
int status_of_fork(const Status& status) {
    const pid_t child = fork();
    if (child == 0) {
        _exit(status());
    }
    int found = -1;
    EXPECT_EQ(waitpid(child, &found, 0), child);
    return WIFEXITED(found) ? WEXITSTATUS(found) : -1;
}

/// How many threads of `others` and the calling one work at the same time: each waits for all.
int size_of_team(int others) {
    std::atomic<int> there{0};
    run_with_others(others, [&](int) {
        ++there;
        while (there <= others) {
            std::this_thread::yield();
        }
    });
    return there;
}

int before = 0;
int in_parent = 0;
int in_child = 0;

TEST(Posix, BothProcessesAreToldOfAFork) {
    at_fork([] { ++before; }, [] { ++in_parent; }, [] { ++in_child; });
    at_fork(nullptr, nullptr, nullptr);
    EXPECT_EQ(status_of_fork([] { return 100 * before + 10 * in_parent + in_child; }), 101);
    EXPECT_EQ(100 * before + 10 * in_parent + in_child, 110);
}

TEST(Posix, AForkedProcessStartsThreadsOfItsOwn) {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "ThreadSanitizer allows no threads after a fork";
#endif
    EXPECT_EQ(size_of_team(3), 4);
    EXPECT_EQ(status_of_fork([] { return size_of_team(3); }), 4);
}

int ended = 0;

TEST(Posix, TheEndOfAThreadIsTold) {
    std::thread([] { at_thread_end([] { ++ended; }); }).join();
    EXPECT_EQ(ended, 1);
}

struct MadeLate {
    std::FILE* stream;
    ~MadeLate() { std::fputs(ended > 0 ? "told" : "destroyed untold", stream); }
};

TEST(Posix, TheThreadThatExitsIsToldBeforeStaticObjectsMadeLateAreDestroyed) {
    int pipe_ends[2];
    ASSERT_EQ(pipe(pipe_ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        at_thread_end([] { ended = 1; });
        ended = 0;
        static const MadeLate late{fdopen(pipe_ends[1], "w")};
        std::exit(0);
    }
    close(pipe_ends[1]);
    char text[32] = {};
    EXPECT_GT(read(pipe_ends[0], text, sizeof text - 1), 0);
    close(pipe_ends[0]);
    int status = -1;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    EXPECT_STREQ(text, "told");
}

TEST(Posix, ProcessorTimeCountsChildrenThatWereWaitedFor) {
    const double start = cpu_seconds();
    status_of_fork([] {
        const double own = cpu_seconds();
        while (cpu_seconds() < own + 0.05) {
        }
        return 0;
    });
    EXPECT_GE(cpu_seconds(), start + 0.05);
}

TEST(Posix, SymbolsOfLoadedLibrariesAreFound) {
    void* const found = symbol_of_library("libc.so.6", "getpid");
#ifdef __GLIBC__
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(reinterpret_cast<pid_t (*)()>(found)(), getpid());
#endif
    EXPECT_EQ(symbol_of_library("libc.so.6", "no_such_function"), nullptr);
    EXPECT_EQ(symbol_of_library("/no/such/library.so", "getpid"), nullptr);
}

}  // namespace
}  // namespace mq
