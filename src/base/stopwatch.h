// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>

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

}  // namespace mq
