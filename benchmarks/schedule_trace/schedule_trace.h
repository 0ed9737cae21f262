// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <string>
#include <utility>
#include <vector>

namespace mq {

/// The work of an operation, as tasks that several threads could share.
struct ScheduleRecord {
    /// A stage of the operation, or a call of the work of parallel_for.
    struct Task {
        int section;     ///< the section that the task belongs to; -1: a stage
        double seconds;  ///< processor time, without the sections within it
    };
    /// A call of parallel_for on more than one thread.
    struct Section {
        int task;     ///< the task that called it
        int threads;  ///< number of threads that would share its tasks
    };
    std::vector<Task> tasks;                          ///< in the order in which they began
    std::vector<Section> sections;                    ///< likewise
    std::vector<std::pair<std::string, int>> stages;  ///< names of stages, and their tasks
};

/// Records an operation, so that its schedule on any number of threads can be simulated. Between `start` and `stop`
/// parallel_for divides its work as for all threads that it may use, but calls one piece after the other in one of
/// them. One operation may run then, which may pass from thread to thread as long as one waits for the other.
class ScheduleTrace {
  public:
    class Task;

    /// A call of parallel_for.
    class Section {
      public:
        /// Recorded while an operation is recorded, if there is more than one thread.
        explicit Section(int threads) {
            if (on() && threads > 1) {
                index_ = begin_section(threads);
            }
        }
        bool recorded() const { return index_ >= 0; }

      private:
        friend class Task;
        int index_ = -1;
    };

    /// A call of its work, as long as the object lives.
    class Task {
      public:
        explicit Task(const Section& section) : recorded_(section.recorded()) {
            if (recorded_) {
                caller_ = begin_task(section.index_);
            }
        }
        ~Task() {
            if (recorded_) {
                end_task(caller_);
            }
        }
        Task(const Task&) = delete;
        Task& operator=(const Task&) = delete;

      private:
        bool recorded_;
        int caller_ = -1;
    };

    static void start();
    static ScheduleRecord stop();
    static bool on() { return on_.load(std::memory_order_relaxed); }
    /// Names the work since the last call: a stage. Ignored in tasks of parallel_for.
    static void name_work(const std::string& name) {
        if (on()) {
            add_stage(name);
        }
    }

  private:
    static int begin_section(int threads);
    /// @return the task that goes on afterwards
    static int begin_task(int section);
    static void end_task(int caller);
    static void add_stage(const std::string& name);

    static std::atomic<bool> on_;
};

}  // namespace mq
