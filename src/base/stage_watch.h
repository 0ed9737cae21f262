// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>

#include "base/progress.h"
#include "base/stopwatch.h"

namespace mq {

/// Tells the watcher of an operation which stage runs, and records how long each takes.
class StageWatch {
  public:
    StageWatch(Progress& progress, StageTimes& times) : progress_(progress), times_(times) {}

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
            const auto named = [this](const auto& entry) { return entry.first == name_; };
            auto entry = std::find_if(times_.begin(), times_.end(), named);
            if (entry == times_.end()) {
                entry = times_.insert(entry, {name_, 0.0});
            }
            entry->second += watch_.wall();
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
