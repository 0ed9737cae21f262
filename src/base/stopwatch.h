// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/system/system.h"
#include "base/threads/schedule_hooks.h"

namespace mq {

/// Wall-clock and processor seconds since its construction.
class Stopwatch {
  public:
    double wall() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
    double cpu() const { return cpu_seconds() - cpu_start_; }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double cpu_start_ = cpu_seconds();
};

/// Stages of an operation in their order, each with its wall-clock seconds.
using StageTimes = std::vector<std::pair<std::string, double>>;

/// Adds seconds to a stage, which is appended where it has not run yet.
inline void add_time(StageTimes& times, const std::string& stage, double seconds) {
    const auto named = [&](const auto& entry) { return entry.first == stage; };
    const auto found = std::find_if(times.begin(), times.end(), named);
    if (found != times.end()) {
        found->second += seconds;
    } else {
        times.emplace_back(stage, seconds);
    }
}

/// Records how long consecutive stages take. The first stage begins when the clock is made.
class StageTimer {
  public:
    explicit StageTimer(StageTimes& times) : times_(times) {}

    /// Ends the running stage and gives it its name. A stage that runs again adds to its time.
    void end(const std::string& stage) {
        add_time(times_, stage, since_last());
        ScheduleTrace::name_work(stage);
    }
    /// Ends the running stage, in which several stages ran in parallel for these times. Each of them gets its share of
    /// the time.
    void end_together(const StageTimes& stages) {
        const double seconds = since_last();
        ScheduleTrace::name_work("stages of bodies");
        double sum = 0.0;
        for (const auto& [stage, time] : stages) {
            sum += time;
        }
        for (const auto& [stage, time] : stages) {
            add_time(times_, stage, sum > 0.0 ? seconds * time / sum : 0.0);
        }
    }

  private:
    double since_last() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

    StageTimes& times_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Tells the watcher of an operation which stage runs, and records how long each takes.
class WatchedStageTimer {
  public:
    WatchedStageTimer(Progress& progress, StageTimes& times) : progress_(progress), times_(times) {}

    /// Ends the running stage and starts stage `name` (a string literal), which covers the fractions [from, to] of the
    /// whole.
    /// @throws Cancelled
    void start(const char* name, double from, double to) {
        end();
        name_ = name;
        progress_.stage(name, from, to);
        progress_.check();
    }
    /// Ends the running stage. A stage that runs again adds to its time.
    void end() {
        if (name_ != nullptr) {
            add_time(times_, name_, watch_.wall());
            ScheduleTrace::name_work(name_);
        }
        watch_ = Stopwatch();
        name_ = nullptr;
    }

  private:
    Progress& progress_;
    StageTimes& times_;
    const char* name_ = nullptr;
    Stopwatch watch_;
};

}  // namespace mq
