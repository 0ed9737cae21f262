// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <memory>

namespace mq {

/// Threads that are kept for later calls: to wake one takes less time than to start one. They are started on demand.
class KeptThreads {
  public:
    KeptThreads();
    /// Ends the threads, once the calls that they work on have ended.
    ~KeptThreads();
    KeptThreads(const KeptThreads&) = delete;
    KeptThreads& operator=(const KeptThreads&) = delete;

    /// Calls `work` in one of the threads and `meanwhile` in the calling thread, and returns when both have ended.
    /// @param work, meanwhile  must not throw
    /// @throws std::system_error, std::bad_alloc when the system gives no thread; nothing is called then
    void run(const std::function<void()>& work, const std::function<void()>& meanwhile);

    /// Whether the calling thread is one of these.
    bool own_this_thread() const { return present() == this; }

    /// Makes the calling thread, which this object did not start, one of its threads while the Member lives.
    class Member {
      public:
        explicit Member(KeptThreads& threads) : before_(present()) { present() = &threads; }
        ~Member() { present() = before_; }
        Member(const Member&) = delete;
        Member& operator=(const Member&) = delete;

      private:
        KeptThreads* before_;
    };

  private:
    class Impl;
    friend void run_with_others(int others, const std::function<void(int)>& work);
    static KeptThreads& of_process();
    /// The kept threads to which the calling thread belongs; null: it belongs to none.
    static KeptThreads*& present() {
        thread_local KeptThreads* threads = nullptr;
        return threads;
    }

    std::unique_ptr<Impl> impl_;
};

/// Calls work(0) in the calling thread and work(1) .. work(others) in other threads at the same time, and returns when
/// all have ended. Calls that have not begun at the end of work(0) are left out, and so are those for which the system
/// gives no more threads. The other threads are of the same KeptThreads as the calling thread, or else of the process.
/// Several threads may call it at a time, also from `work`.
/// @param work  must not throw
void run_with_others(int others, const std::function<void(int)>& work);

}  // namespace mq
