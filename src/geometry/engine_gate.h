// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "base/error.h"

namespace mq::geometry {

/// The error of all who need the engine after its end.
Cancelled engine_has_ended();

/// Lets the threads of a job answer queries themselves while the engine's main thread waits at the gate
/// (Engine::run_job). The gate closes while somebody else needs the engine: the job's threads then wait with their next
/// question.
class EngineGate {
  public:
    /// Keeps the engine's main thread waiting while the object lives. A thread may have only one at a time.
    class Entry {
      public:
        /// @throws Cancelled when the engine's main thread does not come any more
        explicit Entry(EngineGate& gate) : gate_(gate) { gate_.enter(); }
        ~Entry() { gate_.leave(); }
        Entry(const Entry&) = delete;
        Entry& operator=(const Entry&) = delete;

      private:
        EngineGate& gate_;
    };

    /// Time for which the gate stays open although somebody waits: enough for a query, and much less than users notice.
    static constexpr std::chrono::milliseconds kOpenAtLeast{2};

    /// On the engine's main thread: opens the gate to the other threads until somebody waits, or until `close`, and
    /// waits until all of them have left.
    void open() {
        std::unique_lock<std::mutex> lock(mutex_);
        open_ = true;
        changed_.notify_all();
        changed_.wait_for(lock, kOpenAtLeast, [this] { return closed_; });
        changed_.wait(lock, [this] { return closed_ || somebody_waits_; });
        open_ = false;
        somebody_waits_ = false;
        changed_.wait(lock, [this] { return inside_ == 0; });
    }
    /// Called by a thread that needs the engine.
    void let_through() {
        const std::lock_guard<std::mutex> lock(mutex_);
        somebody_waits_ = true;
        changed_.notify_all();
    }
    /// Closes the gate for good.
    void close() {
        const std::lock_guard<std::mutex> lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }
    bool closed() const {
        const std::lock_guard<std::mutex> lock(mutex_);
        return closed_;
    }

  private:
    void enter() {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [this] { return open_ || closed_; });
        if (closed_) {
            throw engine_has_ended();
        }
        ++inside_;
    }
    void leave() {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (--inside_ == 0 && !open_) {
            changed_.notify_all();
        }
    }

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool open_ = false;
    bool closed_ = false;
    bool somebody_waits_ = false;
    int inside_ = 0;
};

}  // namespace mq::geometry
