// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/waits.h"

#include <gtest/gtest.h>

namespace mq {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;

TEST(Waits, NamesWhatLastsLongEnough) {
    Progress progress;
    const Waits waits(progress, "job");
    EXPECT_EQ(waits.lasting(milliseconds(0)), "") << "it works";
    Waits::set(&progress, "a file");
    EXPECT_EQ(waits.lasting(milliseconds(0)), "a file");
    EXPECT_EQ(waits.lasting(hours(1)), "");
    Waits::set(&progress, "");
    EXPECT_EQ(waits.lasting(milliseconds(0)), "");
}

TEST(Waits, OfOpenCascadeEndWithTheirObject) {
    Progress progress;
    const Waits waits(progress, "job");
    {
        const OpenCascadeWait wait(&progress, "checking Face1");
        EXPECT_EQ(waits.lasting(milliseconds(0)), "OpenCASCADE: checking Face1");
    }
    EXPECT_EQ(waits.lasting(milliseconds(0)), "");
}

TEST(Waits, AreListedByTheTitlesOfTheirOperations) {
    Progress one;
    Progress two;
    Progress unwatched;
    const Waits first(one, "first");
    {
        const Waits second(two, "second");
        EXPECT_EQ(Waits::title_of(&one), "first");
        EXPECT_EQ(Waits::title_of(&two), "second");
        Waits::set(&two, "its turn");
        const auto all = Waits::all_lasting(milliseconds(0));
        ASSERT_EQ(all.size(), 1u);
        EXPECT_EQ(all[0].first, "second");
        EXPECT_EQ(all[0].second, "its turn");
    }
    EXPECT_TRUE(Waits::all_lasting(milliseconds(0)).empty());
    EXPECT_EQ(Waits::title_of(&two), "");
    EXPECT_EQ(Waits::title_of(nullptr), "");
    Waits::set(&unwatched, "nobody asks");
    Waits::set(nullptr, "nobody asks");
    EXPECT_TRUE(Waits::all_lasting(milliseconds(0)).empty());
}

}  // namespace
}  // namespace mq
