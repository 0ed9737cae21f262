// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Where parallel_for and the clocks of stages tell of their work. A build with MESHQUALITY_SCHEDULE_TRACE records it,
// to simulate more cores than the machine has (benchmarks/cores.py); others hear nothing.
#ifdef MESHQUALITY_SCHEDULE_TRACE
#include "schedule_trace/schedule_trace.h"
#else

#include <string>

namespace mq {

struct ScheduleTrace {
    /// A call of parallel_for.
    struct Section {
        explicit Section(int /*threads*/) {}
        static constexpr bool recorded() { return false; }
    };
    /// A call of its work, as long as the object lives.
    struct Task {
        explicit Task(const Section& /*section*/) {}
    };
    /// Names the work since the last call: a stage.
    static void name_work(const std::string& /*stage*/) {}
};

}  // namespace mq
#endif
