// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/progress.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace mq {
namespace {

TEST(Progress, StartsAtZero) {
    const Progress progress;
    EXPECT_EQ(progress.fraction(), 0.0);
    EXPECT_EQ(std::string(progress.name()), "start");
    EXPECT_FALSE(progress.cancelled());
    EXPECT_NO_THROW(progress.check());
}

TEST(Progress, MapsAStageToItsShareOfTheWhole) {
    Progress progress;
    progress.stage("curves", 0.2, 0.6);
    EXPECT_EQ(std::string(progress.name()), "curves");
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.2);
    progress.advance(0.5);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.4);
    progress.advance(1.0);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.6);
}

TEST(Progress, StagesOfAStepCoverTheShareOfIt) {
    Progress progress;
    {
        const ProgressShare step(progress, 0.2, 0.6);
        const ProgressShare piece(progress, 0.5, 1.0);
        progress.stage("surfaces", 0.0, 0.5);
        EXPECT_DOUBLE_EQ(progress.fraction(), 0.4);
        progress.advance(1.0);
        EXPECT_DOUBLE_EQ(progress.fraction(), 0.5);
    }
    progress.stage("measuring", 0.5, 1.0);
    progress.advance(1.0);
    EXPECT_DOUBLE_EQ(progress.fraction(), 1.0);
}

TEST(Progress, NeverRunsBackwardsWithinAStage) {
    Progress progress;
    progress.stage("surfaces", 0.0, 1.0);
    progress.advance(0.7);
    progress.advance(0.3);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.7);
}

TEST(Progress, CancellingThrowsInTheWorker) {
    Progress progress;
    progress.cancel();
    EXPECT_TRUE(progress.cancelled());
    EXPECT_THROW(progress.check(), Cancelled);
}

TEST(Progress, AWatcherSeesItGrowAndStopsTheWorker) {
    Progress progress;
    std::thread worker([&] {
        try {
            for (int round = 0;; ++round) {
                if (round % 1000 == 0) {
                    progress.stage(round == 0 ? "first" : "later", progress.fraction(), 1.0);
                }
                progress.advance((round % 1000) * 1e-6);
                progress.check();
            }
        } catch (const Cancelled&) {
        }
    });
    double last = 0.0;
    for (int i = 0; i < 10000 || last == 0.0; ++i) {
        const double now = progress.fraction();
        EXPECT_GE(now, last);
        EXPECT_LE(now, 1.0);
        last = now;
    }
    progress.cancel();
    worker.join();
    EXPECT_GT(progress.fraction(), 0.0);
}

}  // namespace
}  // namespace mq
