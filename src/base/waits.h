// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "base/progress.h"

namespace mq {

/// The name of what a running operation waits for and cannot interrupt, for whoever watches it: foreign code, or its
/// turn in a queue. Lives as long as the operation; in its worker's code it is found by the handle of the operation.
class Waits {
  public:
    /// @param title the name of the operation, shown where others wait for it.
    Waits(const Progress& progress, std::string title);
    ~Waits();
    Waits(const Waits&) = delete;
    Waits& operator=(const Waits&) = delete;

    /// Watcher: the name of what the operation waits for; empty when the wait has lasted less than `least`.
    Message lasting(std::chrono::steady_clock::duration least) const;

    /// The titles of all operations that have waited for at least this time, and for what.
    static std::vector<std::pair<std::string, Message>> all_lasting(std::chrono::steady_clock::duration least);
    /// The title of an operation; empty for one without a watcher, and for none.
    static std::string title_of(const Progress* progress);
    /// Worker: from now on the operation waits for `what`; empty: it works. No effect without a watcher.
    static void set(const Progress* progress, Message what);

  private:
    const Progress& progress_;
    const std::string title_;
    mutable std::mutex mutex_;
    Message what_;
    std::chrono::steady_clock::time_point since_;
};

/// During its lifetime the operation waits for OpenCASCADE, which does what `doing` says. Not to be nested.
class OpenCascadeWait {
  public:
    OpenCascadeWait(const Progress* progress, Message doing);
    OpenCascadeWait(const Progress* progress, const std::string& stage)
        : OpenCascadeWait(progress, Message::value(stage)) {}
    ~OpenCascadeWait() { Waits::set(progress_, Message()); }
    OpenCascadeWait(const OpenCascadeWait&) = delete;
    OpenCascadeWait& operator=(const OpenCascadeWait&) = delete;

  private:
    const Progress* progress_;
};

}  // namespace mq
