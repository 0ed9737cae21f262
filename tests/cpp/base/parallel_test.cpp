// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace mq {
namespace {

TEST(ForAll, CallsEachOnce) {
    std::vector<int> calls(1000, 0);
    parallel_for(1000, [&](int k) { ++calls[static_cast<std::size_t>(k)]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1));
    parallel_for(0, [](int) { FAIL() << "there is nothing to do"; });
}

TEST(ForAll, ThrowsWhatAWorkThrew) {
    for (int round = 0; round < 50; ++round) {
        try {
            parallel_for(8, [](int k) {
                if (k == 3) {
                    throw std::runtime_error("three");
                }
            });
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()), "three");
        }
    }
}

TEST(ForAll, CallsWithinCallsShareTheThreads) {
    const ThreadLimit limit(6);
    std::vector<int> inner(2, 0);
    parallel_for(2, [&](int k) { inner[static_cast<std::size_t>(k)] = thread_count(); });
    EXPECT_EQ(inner, std::vector<int>(2, 3));
    parallel_for(1, [&](int) { inner[0] = thread_count(); });
    EXPECT_EQ(inner[0], 6);
    EXPECT_EQ(thread_count(), 6);
}

TEST(ForAll, CountsPredicatesForTheCallersThread) {
    for (const int threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        predicate_count() = {};
        parallel_for(100, [](int k) { sign_dot(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(k - 50.0, 1, 0)); });
        EXPECT_EQ(predicate_count().filtered + predicate_count().exact, 100U);
    }
}

TEST(ForChunks, UsesAsManyThreadsAsAreWorthIt) {
    const ThreadLimit limit(4);
    const auto at_a_time = [](int count, int worth) {
        std::vector<int> threads(static_cast<std::size_t>(count), 0);
        for_chunks(count, worth, [&](int k) { threads[static_cast<std::size_t>(k)] = thread_count(); });
        return threads;
    };
    EXPECT_EQ(at_a_time(150, 100), std::vector<int>(150, 1));
    EXPECT_EQ(at_a_time(1000, 1).size(), 1000U);
    EXPECT_EQ(thread_count(), 4);
}

TEST(ThreadLimit, OfNoneKeepsTheOneAround) {
    const ThreadLimit outer(3);
    {
        const ThreadLimit inner(0);
        EXPECT_EQ(thread_count(), 3);
    }
    EXPECT_EQ(thread_count(), 3);
}

TEST(ThreadsFor, GivesEachThreadWhatIsWorthItsStart) {
    const ThreadLimit limit(4);
    EXPECT_EQ(threads_for(0, 100), 1);
    EXPECT_EQ(threads_for(199, 100), 1);
    EXPECT_EQ(threads_for(200, 100), 2);
    EXPECT_EQ(threads_for(5000, 100), 4);
}

}  // namespace
}  // namespace mq
