// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/threads/kept_threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace mq {
namespace {

using Ids = std::set<std::thread::id>;

/// Runs work on this many threads, each of which waits until all are there. @return their ids
Ids ids_of_team(int others) {
    std::mutex mutex;
    Ids ids;
    std::atomic<int> there{0};
    run_with_others(others, [&](int) {
        {
            const std::lock_guard<std::mutex> lock(mutex);
            ids.insert(std::this_thread::get_id());
        }
        ++there;
        while (there <= others) {
            std::this_thread::yield();
        }
    });
    return ids;
}

TEST(KeptThreads, NoneAreNeededForNoCalls) {
    int calls = 0;
    run_with_others(0, [&](int) { ++calls; });
    run_with_others(-1, [&](int) { ++calls; });
    EXPECT_EQ(calls, 2);
}

TEST(KeptThreads, CallsRunAtTheSameTimeInThreadsOfTheirOwn) {
    const Ids ids = ids_of_team(5);
    EXPECT_EQ(ids.size(), 6U);
    EXPECT_EQ(ids.count(std::this_thread::get_id()), 1U);
    EXPECT_EQ(ids_of_team(0), Ids{std::this_thread::get_id()});
}

TEST(KeptThreads, AreTheSameInTheNextCall) {
    const Ids first = ids_of_team(4);
    EXPECT_EQ(ids_of_team(4), first);
    for (const std::thread::id id : ids_of_team(2)) {
        EXPECT_EQ(first.count(id), 1U);
    }
}

TEST(KeptThreads, EachNumberIsCalledAtMostOnceAndZeroAlways) {
    for (int round = 0; round < 2000; ++round) {
        std::vector<std::atomic<int>> calls(5);
        run_with_others(4, [&](int number) { ++calls[static_cast<std::size_t>(number)]; });
        EXPECT_EQ(calls[0], 1);
        for (const std::atomic<int>& count : calls) {
            EXPECT_LE(count, 1);
        }
    }
}

TEST(KeptThreads, ReturnsOnlyWhenCallsThatBeganHaveEnded) {
    std::atomic<bool> begun{false};
    std::atomic<bool> ended{false};
    run_with_others(1, [&](int number) {
        if (number == 0) {
            while (!begun) {
                std::this_thread::yield();
            }
            return;
        }
        begun = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ended = true;
    });
    EXPECT_TRUE(ended);
}

TEST(KeptThreads, CallsWithinCallsAndFromSeveralThreads) {
    std::atomic<int> sum{0};
    const auto work = [&] {
        for (int round = 0; round < 100; ++round) {
            std::atomic<int> next{0};
            run_with_others(3, [&](int) {
                while (next++ < 10) {
                    std::atomic<int> inner{0};
                    run_with_others(2, [&](int) {
                        while (inner++ < 5) {
                            ++sum;
                        }
                    });
                }
            });
        }
    };
    std::thread other(work);
    work();
    other.join();
    EXPECT_EQ(sum, 2 * 100 * 10 * 5);
}

TEST(KeptThreads, WorkRunsInOneOfThemWhileTheCallerDoesSomethingElse) {
    KeptThreads threads;
    std::atomic<int> arrived{0};
    std::thread::id first;
    for (int round = 0; round < 3; ++round) {
        arrived = 0;
        const auto meet = [&](bool own) {
            ++arrived;
            while (arrived < 2) {
                std::this_thread::yield();
            }
            EXPECT_EQ(threads.own_this_thread(), own);
        };
        std::thread::id id;
        threads.run(
            [&] {
                meet(true);
                id = std::this_thread::get_id();
            },
            [&] { meet(false); });
        EXPECT_NE(id, std::this_thread::get_id());
        first = round == 0 ? id : first;
        EXPECT_EQ(id, first);
    }
}

TEST(KeptThreads, HelpersOfOneOfThemAreOfThem) {
    const Ids of_process = ids_of_team(4);
    Ids team;
    {
        KeptThreads threads;
        std::atomic<int> own{0};
        threads.run(
            [&] {
                team = ids_of_team(4);
                run_with_others(3, [&](int) { own += threads.own_this_thread() ? 1 : 100; });
            },
            [] {});
        EXPECT_GT(own, 0);
        EXPECT_LT(own, 5);
        const KeptThreads::Member member(threads);
        EXPECT_TRUE(threads.own_this_thread());
        const Ids beside = ids_of_team(4);
        EXPECT_EQ(std::count_if(beside.begin(), beside.end(), [&](auto id) { return team.count(id) == 1; }), 4);
    }
    EXPECT_EQ(std::count_if(team.begin(), team.end(), [&](auto id) { return of_process.count(id) == 1; }), 0);
    EXPECT_EQ(ids_of_team(4), of_process);
}

}  // namespace
}  // namespace mq
