// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sys/types.h>

#include <string>

#include "base/progress.h"

namespace mq {

/// A program that takes bytes on its standard input and gives bytes on its standard output.
///
/// It is ended when the work is cancelled or this object is destroyed.
class ChildProcess {
  public:
    /// @throws IoError naming the program when it cannot be started.
    explicit ChildProcess(const std::string& program);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Sends the input and returns the whole output; checks for cancellation every few milliseconds.
    /// @throws Cancelled.
    std::string exchange(const std::string& input, const Progress& progress);
    /// The way in which the program ended; valid after `exchange`.
    struct End {
        std::string fault;      ///< "" when it ended well
        bool too_long = false;  ///< the program exceeded its time limit
    };
    End end();

  private:
    void close_end(int& end);

    pid_t pid_ = -1;
    int to_ = -1;
    int from_ = -1;
};

}  // namespace mq
