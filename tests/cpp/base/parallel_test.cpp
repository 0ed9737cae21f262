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

TEST(ThreadsFor, GivesEachThreadWhatIsWorthItsStart) {
    const ThreadLimit limit(4);
    EXPECT_EQ(threads_for(0, 100), 1);
    EXPECT_EQ(threads_for(199, 100), 1);
    EXPECT_EQ(threads_for(200, 100), 2);
    EXPECT_EQ(threads_for(5000, 100), 4);
}

}  // namespace
}  // namespace mq
