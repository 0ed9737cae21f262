// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <string>

#include "base/error.h"

namespace mq {

/// The handle of one running operation, shared by the thread that works and the one that watches.
///
/// The worker names its stage and advances the fraction; the watcher polls both and may cancel. Nothing is called
/// back. Stages are string literals, so that a reader on another thread never sees a string being changed.
class Progress {
  public:
    Progress() = default;
    /// The progress of a piece of another operation: it is cancelled with that operation, and its stages are not shown.
    explicit Progress(const Progress* whole) : whole_(whole) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Worker: starts stage `name` (a string literal), which covers the fractions [from, to] of the whole, or the rest
    /// if less is left, as in a second attempt.
    void stage(const char* name, double from, double to) {
        name_.store(name, std::memory_order_release);
        from_.store(low_ + from * (high_ - low_), std::memory_order_relaxed);
        to_.store(low_ + to * (high_ - low_), std::memory_order_relaxed);
        advance(0.0);
    }
    /// Worker, in any of its threads: `done` in [0, 1] of the current stage. The fraction never runs backwards.
    void advance(double done) {
        const double from = from_.load(std::memory_order_relaxed);
        const double value = from + done * (to_.load(std::memory_order_relaxed) - from);
        double before = fraction_.load(std::memory_order_relaxed);
        while (value > before && !fraction_.compare_exchange_weak(before, value, std::memory_order_relaxed)) {
        }
    }
    /// Worker: throws Cancelled once the watcher has requested it. Cheap: call it in every round.
    void check() const {
        if (cancelled()) {
            refuse();
        }
    }

    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool cancelled() const {
        return cancelled_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->cancelled());
    }
    double fraction() const { return fraction_.load(std::memory_order_relaxed); }
    const char* name() const { return name_.load(std::memory_order_acquire); }

  private:
    friend class ProgressShare;

    [[noreturn]] static void refuse();

    std::atomic<const char*> name_{"start"};
    std::atomic<double> from_{0.0};
    std::atomic<double> to_{1.0};
    std::atomic<double> fraction_{0.0};
    std::atomic<bool> cancelled_{false};
    const Progress* whole_ = nullptr;
    double low_ = 0.0;  // what the stages' fractions are of: the worker's alone
    double high_ = 1.0;
};

/// While it lives, the stages of an operation cover its fractions [from, to] alone: those of one step of several.
class ProgressShare {
  public:
    ProgressShare(Progress& progress, double from, double to)
        : progress_(progress), low_(progress.low_), high_(progress.high_) {
        progress.low_ = low_ + from * (high_ - low_);
        progress.high_ = low_ + to * (high_ - low_);
    }
    ~ProgressShare() {
        progress_.low_ = low_;
        progress_.high_ = high_;
    }
    ProgressShare(const ProgressShare&) = delete;
    ProgressShare& operator=(const ProgressShare&) = delete;

  private:
    Progress& progress_;
    double low_;
    double high_;
};

/// Checks for a cancellation where there may be no watcher.
/// @throws Cancelled
inline void check_cancelled(const Progress* progress) {
    if (progress != nullptr) {
        progress->check();
    }
}

/// Checks for a cancellation at every 4096th step of a long loop.
class CancelPace {
  public:
    explicit CancelPace(const Progress* progress) : progress_(progress) {}
    explicit CancelPace(const Progress& progress) : progress_(&progress) {}
    /// @throws Cancelled
    void step() {
        /// Steps between two checks: their cost is then negligible.
        constexpr unsigned kBetweenChecks = 4096;
        if (progress_ != nullptr && ++steps_ % kBetweenChecks == 0) {
            progress_->check();
        }
    }

  private:
    const Progress* progress_;
    unsigned steps_ = 0;
};

}  // namespace mq
