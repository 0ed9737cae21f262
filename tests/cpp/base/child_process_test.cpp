// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/child_process.h"

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"

namespace mq {
namespace {

TEST(ChildProcess, GivesBackWhatTheProgramWrites) {
    const Progress progress;
    ChildProcess cat("/bin/cat");
    // More than a pipe holds, so that both ends must be served in turn.
    const std::string input(1 << 20, 'x');
    EXPECT_EQ(cat.exchange(input, progress), input);
    const ChildProcess::End end = cat.end();
    EXPECT_EQ(end.fault, "");
    EXPECT_FALSE(end.too_long);
}

TEST(ChildProcess, TellsHowAProgramFailed) {
    const Progress progress;
    ChildProcess failing("/bin/false");
    EXPECT_EQ(failing.exchange("not read", progress), "");
    EXPECT_NE(failing.end().fault.find("status 1"), std::string::npos);
}

TEST(ChildProcess, NamesAProgramThatIsNotThere) {
    try {
        ChildProcess("/no/such/program");
        FAIL();
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("/no/such/program"), std::string::npos) << error.what();
    }
}

TEST(ChildProcess, EndsWhenTheWorkIsCancelled) {
    Progress progress;
    progress.cancel();
    ChildProcess cat("/bin/cat");
    EXPECT_THROW(cat.exchange(std::string(1 << 20, 'x'), progress), Cancelled);
}

}  // namespace
}  // namespace mq
