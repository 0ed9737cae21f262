// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <future>
#include <string>
#include <utility>

#include "base/progress.h"
#include "base/waits.h"
#include "python/bindings.h"
#include "python/python_lock.h"
#include "python/running_work.h"

namespace mq::python {

/// Waits shorter than this are not named, as the stage would flicker; windows name longer ones within 0.5 s.
constexpr std::chrono::milliseconds kLongestUnnamedWait{300};

/// Python's view of a running operation: calls back on the thread that called in, never on the worker's.
class Watcher {
  public:
    Watcher(Progress& progress, pybind11::object callback)
        : progress_(progress), waits_(progress, title()), callback_(std::move(callback)) {}

    /// With the GIL: checks for Ctrl-C, and calls back when something changed or some time has passed, since the answer
    /// is the caller's only way to cancel. An exception of the callback cancels the work and is kept for `rethrow`.
    void poll() {
        if (progress_.cancelled()) {
            return;
        }
        try {
            if (PyErr_CheckSignals() != 0) {
                throw pybind11::error_already_set();
            }
            const Message wait = waits_.lasting(kLongestUnnamedWait);
            report(progress_.fraction(), wait.empty() ? Message::value(progress_.name()) : wait);
        } catch (...) {
            raised_ = std::current_exception();
            progress_.cancel();
        }
    }
    void report(double fraction, const Message& stage) {
        /// Time between two calls back at most: a cancellation takes effect within 0.2 s.
        constexpr std::chrono::milliseconds kLongestSilence(50);
        const auto now = std::chrono::steady_clock::now();
        const bool same = fraction == fraction_ && stage == stage_;
        if (callback_.is_none() || (same && now - called_ < kLongestSilence)) {
            return;
        }
        called_ = now;
        fraction_ = fraction;
        stage_ = stage;
        const pybind11::tuple arguments = pybind11::make_tuple(fraction, text_of(stage));
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
    /// The name under which others wait for this operation: that of its thread in Python.
    static std::string title() {
        return pybind11::str(pybind11::module_::import("threading").attr("current_thread")().attr("name"));
    }

    Progress& progress_;
    Waits waits_;
    pybind11::object callback_;
    std::chrono::steady_clock::time_point called_;
    double fraction_ = -1.0;
    Message stage_;
    std::exception_ptr raised_;
};

/// Runs `work(Progress&)` on a thread of its own and returns its result. `callback` is None or a callable (fraction,
/// stage) that may return False to cancel. The GIL is released except during calls back.
template <typename Work>
auto watch(const pybind11::object& callback, Work&& work) {
    // Time between two looks at the work: short enough to react well within 0.2 s, and long enough to cost nothing.
    constexpr std::chrono::milliseconds kSlice(20);
    Progress progress;
    Watcher watcher(progress, callback);
    watcher.poll();
    RunningWork running(progress);
    auto future = std::async(std::launch::async, [&] {
        const RunningWork::End end(running);
        progress.check();
        return work(progress);
    });
    {
        FreedLock free;
        while (future.wait_for(kSlice) != std::future_status::ready) {
            free.locked([&] { watcher.poll(); });
        }
    }
    watcher.rethrow();
    auto result = future.get();
    watcher.report(1.0, Message::value("done"));
    progress.check();
    return result;
}

}  // namespace mq::python
