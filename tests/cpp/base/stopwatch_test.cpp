// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/stopwatch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace mq {
namespace {

/// Computes until the clock of the process has gone on by this.
void work_for(double seconds) {
    const double end = cpu_seconds() + seconds;
    volatile double sum = 0.0;
    while (cpu_seconds() < end) {
        for (int i = 0; i < 1000; ++i) {
            sum = sum + 1.0 / (1.0 + i);
        }
    }
}

TEST(Stopwatch, ProcessorTimeCountsTheWorkOfAllThreads) {
    const Stopwatch watch;
    std::thread other([] { work_for(0.06); });
    other.join();
    EXPECT_GE(watch.cpu(), 0.05);
    EXPECT_LE(cpu_seconds() - watch.cpu(), cpu_seconds());
}

TEST(Stopwatch, WaitingTakesWallClockTimeOnly) {
    const Stopwatch watch;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_GE(watch.wall(), 0.05);
    EXPECT_LT(watch.cpu(), watch.wall());
}

TEST(StageTimer, AStageThatRunsAgainAddsToItsTime) {
    StageTimes times;
    StageTimer clock(times);
    clock.end("first");
    clock.end("second");
    const double before = times[0].second;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    clock.end("first");
    ASSERT_EQ(times.size(), 2U);
    EXPECT_EQ(times[0].first, "first");
    EXPECT_GE(times[0].second, before + 0.005);
}

TEST(StageTimer, StagesThatRanSideBySideShareTheTime) {
    StageTimes times;
    StageTimer clock(times);
    std::this_thread::sleep_for(std::chrono::milliseconds(8));
    clock.end_together({{"first", 1.0}, {"second", 2.0}, {"first", 1.0}});
    ASSERT_EQ(times.size(), 2U);
    EXPECT_GE(times[0].second, 0.004);
    EXPECT_DOUBLE_EQ(times[0].second, times[1].second);
}

}  // namespace
}  // namespace mq
