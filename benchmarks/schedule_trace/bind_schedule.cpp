// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "python/bindings.h"
#include "schedule_trace/schedule_trace.h"

namespace py = pybind11;

namespace mq::python {

namespace {

py::dict stop_recording() {
    const ScheduleRecord record = ScheduleTrace::stop();
    std::vector<std::pair<int, double>> tasks;
    for (const ScheduleRecord::Task& task : record.tasks) {
        tasks.emplace_back(task.section, task.seconds);
    }
    std::vector<std::pair<int, int>> sections;
    for (const ScheduleRecord::Section& section : record.sections) {
        sections.emplace_back(section.task, section.threads);
    }
    py::dict result;
    result["tasks"] = tasks;
    result["sections"] = sections;
    result["stages"] = record.stages;
    return result;
}

double seconds_of_empty_section(int threads) {
    // Other programs only add to the time: the shortest of several counts.
    constexpr int kTimes = 51;
    // Serial work before a section, after which other cores may sleep.
    constexpr double kSerial = 1e-3;
    const ThreadLimit limit(threads);
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kTimes; ++i) {
        for (const Stopwatch serial; serial.wall() < kSerial;) {
        }
        const Stopwatch watch;
        parallel_for(threads, [](int) {});
        shortest = std::min(shortest, watch.wall());
    }
    return shortest;
}

}  // namespace

void bind_schedule(py::module_& m) {
    m.def("start_recording", &ScheduleTrace::start,
          "For benchmarks/cores.py: records the tasks of the next operation, which runs in one thread.");
    m.def("stop_recording", &stop_recording,
          "{'tasks': [(section or -1, processor seconds without sections within), ...], 'sections': [(task, threads), "
          "...], 'stages': [(name, task), ...]} since start_recording.");
    m.def("seconds_of_empty_section", &seconds_of_empty_section, py::arg("threads"),
          "How long work without tasks takes on several threads: the cost of starting and ending them.");
}

}  // namespace mq::python
