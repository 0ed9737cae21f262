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
    EXPECT_EQ(waits.lasting(milliseconds(0)).text(), "") << "it works";
    Waits::set(&progress, Message::value("a file"));
    EXPECT_EQ(waits.lasting(milliseconds(0)).text(), "a file");
    EXPECT_EQ(waits.lasting(hours(1)).text(), "");
    Waits::set(&progress, Message());
    EXPECT_EQ(waits.lasting(milliseconds(0)).text(), "");
}

TEST(Waits, OfOpenCascadeEndWithTheirObject) {
    Progress progress;
    const Waits waits(progress, "job");
    {
        const OpenCascadeWait wait(&progress, "checking Face1");
        EXPECT_EQ(waits.lasting(milliseconds(0)).text(), "waits for OpenCASCADE: checking Face1");
    }
    EXPECT_EQ(waits.lasting(milliseconds(0)).text(), "");
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
        Waits::set(&two, Message::value("its turn"));
        const auto all = Waits::all_lasting(milliseconds(0));
        ASSERT_EQ(all.size(), 1u);
        EXPECT_EQ(all[0].first, "second");
        EXPECT_EQ(all[0].second, Message::value("its turn"));
    }
    EXPECT_TRUE(Waits::all_lasting(milliseconds(0)).empty());
    EXPECT_EQ(Waits::title_of(&two), "");
    EXPECT_EQ(Waits::title_of(nullptr), "");
    Waits::set(&unwatched, Message::value("nobody asks"));
    Waits::set(nullptr, Message::value("nobody asks"));
    EXPECT_TRUE(Waits::all_lasting(milliseconds(0)).empty());
}

}  // namespace
}  // namespace mq
