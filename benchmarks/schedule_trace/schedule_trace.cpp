// SPDX-License-Identifier: LGPL-2.1-or-later
#include "schedule_trace/schedule_trace.h"

#include <time.h>

namespace mq {

namespace {

struct Recorder {
    ScheduleRecord record;
    int task = 0;       // the task that runs
    double last = 0.0;  // processor time up to which work has been added to its task
};

Recorder& recorder() {
    static Recorder& instance = *new Recorder();  // never destroyed: threads may work while the process exits
    return instance;
}

double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Adds the time since the last call to the task that runs.
void add_time_to_task(Recorder& recorder) {
    const double now = processor_time();
    recorder.record.tasks[static_cast<std::size_t>(recorder.task)].seconds += now - recorder.last;
    recorder.last = now;
}

void append_task(Recorder& recorder, int section) {
    recorder.task = static_cast<int>(recorder.record.tasks.size());
    recorder.record.tasks.push_back({section, 0.0});
}

}  // namespace

std::atomic<bool> ScheduleTrace::on_{false};

void ScheduleTrace::start() {
    Recorder& now = recorder();
    now.record = {};
    append_task(now, -1);
    now.last = processor_time();
    on_ = true;
}

ScheduleRecord ScheduleTrace::stop() {
    if (!on()) {
        return {};
    }
    add_time_to_task(recorder());
    on_ = false;
    return std::exchange(recorder().record, {});
}

int ScheduleTrace::begin_section(int threads) {
    Recorder& now = recorder();
    now.record.sections.push_back({now.task, threads});
    return static_cast<int>(now.record.sections.size()) - 1;
}

int ScheduleTrace::begin_task(int section) {
    Recorder& now = recorder();
    add_time_to_task(now);
    const int caller = now.task;
    append_task(now, section);
    return caller;
}

void ScheduleTrace::end_task(int caller) {
    Recorder& now = recorder();
    add_time_to_task(now);
    now.task = caller;
}

void ScheduleTrace::add_stage(const std::string& name) {
    Recorder& now = recorder();
    if (now.record.tasks[static_cast<std::size_t>(now.task)].section >= 0) {
        return;
    }
    add_time_to_task(now);
    now.record.stages.emplace_back(name, now.task);
    append_task(now, -1);
}

}  // namespace mq
