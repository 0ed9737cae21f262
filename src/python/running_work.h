// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"

namespace mq::python {

/// An operation that runs on a thread of its own, which Python does not know. All of them are cancelled and waited for
/// when Python ends: the objects that they use are destroyed after that.
class RunningWork {
  public:
    /// @throws Cancelled once Python has begun to end
    explicit RunningWork(Progress& progress);
    ~RunningWork() { end(); }
    RunningWork(const RunningWork&) = delete;
    RunningWork& operator=(const RunningWork&) = delete;

    void cancel() { progress_.cancel(); }
    /// Marks the work as ended. Idempotent; any thread may call it.
    void end();

    /// Ends a piece of work when the scope is left.
    class End {
      public:
        explicit End(RunningWork& work) : work_(work) {}
        ~End() { work_.end(); }
        End(const End&) = delete;
        End& operator=(const End&) = delete;

      private:
        RunningWork& work_;
    };

  private:
    Progress& progress_;
};

/// Has all of it cancelled and waited for when the process exits without ending Python, too, before OpenCASCADE's
/// static objects are destroyed: the work may have made them. To be called once, with Python's lock held.
void end_with_process();

/// Cancels all work, ends the geometry engine, and lets no more work begin. Registered to run before the interpreter
/// ends; call it with Python's lock held. Work that does not end soon, which only foreign code can cause, is left
/// running, and the process then ends without destroying the objects that it uses.
void end_with_python();

}  // namespace mq::python
