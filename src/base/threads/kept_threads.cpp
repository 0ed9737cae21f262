// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/threads/kept_threads.h"

#include <pthread.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace mq {

namespace {

/// Calls that have not ended.
class Calls {
  public:
    explicit Calls(const std::function<void(int)>& work) : work_(work) {}

    void add() {
        const std::lock_guard<std::mutex> lock(mutex_);
        ++running_;
    }
    void call(int number) const { work_(number); }
    void end_one() {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (--running_ == 0) {
            ended_.notify_one();  // with the mutex held: the waiting caller destroys this object
        }
    }
    void wait() {
        std::unique_lock<std::mutex> lock(mutex_);
        ended_.wait(lock, [this] { return running_ == 0; });
    }

  private:
    const std::function<void(int)>& work_;
    std::mutex mutex_;
    std::condition_variable ended_;
    int running_ = 0;
};

/// A thread that waits for calls. It lives as long as the process.
class KeptThread {
  public:
    void give(Calls& calls, int number) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            calls_ = &calls;
            number_ = number;
        }
        given_.notify_one();
    }
    /// @return whether it had not begun, and does not begin any more
    bool take_back(const Calls& calls) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const bool waits = calls_ == &calls;
        calls_ = waits ? nullptr : calls_;
        return waits;
    }
    /// Waits for the next call.
    Calls& begin(int& number) {
        std::unique_lock<std::mutex> lock(mutex_);
        given_.wait(lock, [this] { return calls_ != nullptr; });
        number = number_;
        return *std::exchange(calls_, nullptr);
    }

  private:
    std::mutex mutex_;
    std::condition_variable given_;
    Calls* calls_ = nullptr;  // null: none, or it has begun
    int number_ = 0;
};

struct Waiting {
    std::mutex mutex;
    std::vector<KeptThread*> threads;  // without a call; the last one ended last, and its memory is in caches
    std::size_t made = 0;              // threads that there are: there is room for all of them
};

Waiting& waiting();

// No other thread has the mutex while the process is copied, and threads do not survive that.
void before_fork() {
    waiting().mutex.lock();
}
void after_fork() {
    waiting().mutex.unlock();
}
void after_fork_in_child() {
    waiting().threads.clear();
    waiting().mutex.unlock();
}

Waiting& waiting() {
    static Waiting& instance = []() -> Waiting& {
        pthread_atfork(before_fork, after_fork, after_fork_in_child);
        return *new Waiting();  // never destroyed: the threads wait while the process exits
    }();
    return instance;
}

void keep(KeptThread& thread) {
    const std::lock_guard<std::mutex> lock(waiting().mutex);
    waiting().threads.push_back(&thread);
}

void serve(KeptThread& own) {
    for (;;) {
        int number = 0;
        Calls& calls = own.begin(number);
        calls.call(number);
        keep(own);  // before its caller knows, whose next call finds it waiting
        calls.end_one();
    }
}

/// @return a thread that waits, else a new one
/// @throws std::system_error, std::bad_alloc when there is none to be had
KeptThread& take_one() {
    Waiting& all = waiting();
    {
        const std::lock_guard<std::mutex> lock(all.mutex);
        if (!all.threads.empty()) {
            KeptThread& last = *all.threads.back();
            all.threads.pop_back();
            return last;
        }
        all.threads.reserve(all.made + 1);
        ++all.made;
    }
    KeptThread& fresh = *new KeptThread();
    try {
        std::thread([&fresh] { serve(fresh); }).detach();
    } catch (const std::system_error&) {
        delete &fresh;
        throw;
    }
    return fresh;
}

}  // namespace

void run_with_others(int others, const std::function<void(int)>& work) {
    Calls calls(work);
    std::vector<KeptThread*> given;
    given.reserve(static_cast<std::size_t>(std::max(0, others)));
    for (int number = 1; number <= others; ++number) {
        try {
            given.push_back(&take_one());
        } catch (const std::system_error&) {
            break;  // those that there are do the work
        } catch (const std::bad_alloc&) {
            break;
        }
        calls.add();
        given.back()->give(calls, number);
    }
    work(0);
    for (KeptThread* thread : given) {
        if (thread->take_back(calls)) {
            keep(*thread);
            calls.end_one();
        }
    }
    calls.wait();
}

}  // namespace mq
