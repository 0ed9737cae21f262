// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstring>
#include <exception>
#include <future>

#include "base/progress.h"
#include "python/python_lock.h"
#include "python/running_work.h"

namespace mq::python {

/// Python's view of a running operation: calls back on the thread that called in, never on the worker's.
class Watcher {
  public:
    Watcher(Progress& progress, pybind11::object callback) : progress_(progress), callback_(std::move(callback)) {}

    /// With the GIL: looks for Ctrl-C, and calls back when something changed or some time has passed, since the answer
    /// is the caller's only way to cancel. What is raised cancels the work and is kept for `rethrow`.
    void look() {
        if (progress_.cancelled()) {
            return;
        }
        try {
            if (PyErr_CheckSignals() != 0) {
                throw pybind11::error_already_set();
            }
            report(progress_.fraction(), progress_.name());
        } catch (...) {
            raised_ = std::current_exception();
            progress_.cancel();
        }
    }
    void report(double fraction, const char* stage) {
        constexpr std::chrono::milliseconds kLongestSilence(50);
        const auto now = std::chrono::steady_clock::now();
        const bool same = stage_ != nullptr && fraction == fraction_ && std::strcmp(stage, stage_) == 0;
        if (callback_.is_none() || (same && now - called_ < kLongestSilence)) {
            return;
        }
        called_ = now;
        fraction_ = fraction;
        stage_ = stage;
        const pybind11::tuple arguments = pybind11::make_tuple(fraction, stage);
        PyObject* answer = outliving_python([&] { return PyObject_CallObject(callback_.ptr(), arguments.ptr()); });
        if (answer == nullptr) {
            throw pybind11::error_already_set();
        }
        if (pybind11::reinterpret_steal<pybind11::object>(answer).is(pybind11::bool_(false))) {
            progress_.cancel();
        }
    }
    void rethrow() const {
        if (raised_) {
            std::rethrow_exception(raised_);
        }
    }

  private:
    Progress& progress_;
    pybind11::object callback_;
    std::chrono::steady_clock::time_point called_;
    double fraction_ = -1.0;
    const char* stage_ = nullptr;
    std::exception_ptr raised_;
};

/// Runs `work(Progress&)` on a thread of its own and returns its result. `callback` is None or a callable
/// (fraction, stage) that may return False to cancel. The GIL is free but for the moments of calling back.
template <typename Work>
auto watch(const pybind11::object& callback, Work&& work) {
    // Short enough to react well within 0.2 s, long enough to cost nothing.
    constexpr std::chrono::milliseconds kSlice(20);
    Progress progress;
    Watcher watcher(progress, callback);
    watcher.look();
    RunningWork running(progress);
    auto future = std::async(std::launch::async, [&] {
        const RunningWork::End end(running);
        progress.check();
        return work(progress);
    });
    {
        FreedLock free;
        while (future.wait_for(kSlice) != std::future_status::ready) {
            free.locked([&] { watcher.look(); });
        }
    }
    watcher.rethrow();
    auto result = future.get();
    watcher.report(1.0, "done");
    progress.check();
    return result;
}

}  // namespace mq::python
