// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Python.h>
#include <cxxabi.h>

#include <chrono>
#include <thread>

namespace mq::python {

/// Calls `function`, in which this thread may request Python's lock.
///
/// A daemon thread that requests it while Python ends is ended by Python with pthread_exit, which unwinds the stack:
/// through frames that must not throw, which ends the process with SIGABRT, and through destructors that need the lock.
/// Such a thread stops here without returning instead, as it does by itself from Python 3.14 on.
template <typename Function>
auto outliving_python(const Function& function) {
#ifdef __GLIBCXX__
    try {
        return function();
    } catch (abi::__forced_unwind&) {
        for (;;) {
            std::this_thread::sleep_for(std::chrono::hours(1));
        }
    }
#else
    return function();
#endif
}

/// Python's lock is free during the lifetime of this object. Construct it with the lock held.
class FreedLock {
  public:
    FreedLock() : state_(PyEval_SaveThread()) {}
    ~FreedLock() {
        outliving_python([this] { PyEval_RestoreThread(state_); });
    }
    FreedLock(const FreedLock&) = delete;
    FreedLock& operator=(const FreedLock&) = delete;

    /// Calls `function`, which must not throw, with the lock held.
    template <typename Function>
    void locked(const Function& function) {
        outliving_python([this] { PyEval_RestoreThread(state_); });
        function();
        state_ = PyEval_SaveThread();
    }

  private:
    PyThreadState* state_;
};

}  // namespace mq::python
