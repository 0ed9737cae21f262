// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/threads/schedule_trace.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/stopwatch.h"

namespace mq {
namespace {

/// Computes until the clock of the process has gone on by this.
void work_for(double seconds) {
    const double end = cpu_seconds() + seconds;
    while (cpu_seconds() < end) {
    }
}

std::vector<int> sections_of_tasks(const ScheduleRecord& record) {
    std::vector<int> sections;
    for (const ScheduleRecord::Task& task : record.tasks) {
        sections.push_back(task.section);
    }
    return sections;
}

TEST(ScheduleTrace, RecordsTasksInTheirOrderAndInTheirSections) {
    const ThreadLimit limit(4);
    ScheduleTrace::start();
    parallel_for(2, [](int k) {
        work_for(0.02);
        parallel_for(k + 1, [](int) { work_for(0.01); });  // the first call has one piece: no section
    });
    ScheduleTrace::name_work("both");
    work_for(0.03);
    const ScheduleRecord record = ScheduleTrace::stop();

    EXPECT_EQ(sections_of_tasks(record), (std::vector<int>{-1, 0, 0, 1, 1, -1}));
    ASSERT_EQ(record.sections.size(), 2U);
    EXPECT_EQ(record.sections[0].task, 0);
    EXPECT_EQ(record.sections[0].threads, 2);
    EXPECT_EQ(record.sections[1].task, 2);  // the second call of the outer section
    EXPECT_EQ(record.sections[1].threads, 2);
    ASSERT_EQ(record.stages.size(), 1U);
    EXPECT_EQ(record.stages[0], (std::pair<std::string, int>("both", 0)));
    const std::vector<double> least{0.0, 0.03, 0.02, 0.01, 0.01, 0.03};
    for (std::size_t i = 0; i < least.size(); ++i) {
        EXPECT_GE(record.tasks[i].seconds, 0.9 * least[i]) << i;
        EXPECT_LE(record.tasks[i].seconds, least[i] + 0.02) << i;
    }
}

TEST(ScheduleTrace, CallsOneAfterTheOtherInTheCallersThread) {
    const ThreadLimit limit(4);
    std::vector<int> order;
    ScheduleTrace::start();
    parallel_for_on_threads(100, [&](int thread, int k) {
        EXPECT_EQ(thread, 0);
        order.push_back(k);
    });
    const ScheduleRecord record = ScheduleTrace::stop();
    std::vector<int> all(100);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
    EXPECT_EQ(record.tasks.size(), 101U);
}

TEST(ScheduleTrace, AnExceptionEndsTheTaskAndTheSection) {
    const ThreadLimit limit(2);
    ScheduleTrace::start();
    EXPECT_THROW(parallel_for(5,
                              [](int k) {
                                  if (k == 2) {
                                      throw std::runtime_error("two");
                                  }
                              }),
                 std::runtime_error);
    ScheduleTrace::name_work("failed");
    const ScheduleRecord record = ScheduleTrace::stop();
    EXPECT_EQ(sections_of_tasks(record), (std::vector<int>{-1, 0, 0, 0, -1}));
    EXPECT_EQ(record.stages.size(), 1U);
}

TEST(ScheduleTrace, StagesOfTasksAreNotNamed) {
    const ThreadLimit limit(2);
    ScheduleTrace::start();
    parallel_for(2, [](int) {
        StageTimes times;
        StageTimer(times).end("inner");
    });
    StageTimes times;
    StageTimer(times).end("outer");
    const ScheduleRecord record = ScheduleTrace::stop();
    ASSERT_EQ(record.stages.size(), 1U);
    EXPECT_EQ(record.stages[0].first, "outer");
}

TEST(ScheduleTrace, IsOffUnlessStarted) {
    EXPECT_FALSE(ScheduleTrace::on());
    EXPECT_FALSE(ScheduleTrace::Section(4).recorded());
    ScheduleTrace::start();
    EXPECT_FALSE(ScheduleTrace::Section(1).recorded());
    EXPECT_TRUE(ScheduleTrace::Section(2).recorded());
    EXPECT_EQ(ScheduleTrace::stop().sections.size(), 1U);
    EXPECT_FALSE(ScheduleTrace::on());
}

}  // namespace
}  // namespace mq
