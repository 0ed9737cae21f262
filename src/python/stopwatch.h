// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <ctime>

namespace mq::python {

/// Wall-clock and processor seconds since it was made. Processor time is the whole process's: the work has threads.
class Stopwatch {
  public:
    double wall() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
    double cpu() const { return static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC; }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::clock_t cpu_start_ = std::clock();
};

}  // namespace mq::python
