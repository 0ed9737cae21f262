// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace mq {

/// Processor seconds of this process, all threads, and of the programs it has waited for.
double cpu_seconds();

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

/// Records how long consecutive stages take. The first begins with the clock.
class StageClock {
  public:
    explicit StageClock(StageTimes& times) : times_(times) {}

    /// Ends the running stage and names it.
    void end(const char* stage) {
        const auto now = std::chrono::steady_clock::now();
        times_.emplace_back(stage, std::chrono::duration<double>(now - last_).count());
        last_ = now;
    }

  private:
    StageTimes& times_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace mq
