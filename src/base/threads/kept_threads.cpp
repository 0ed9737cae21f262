// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/threads/kept_threads.h"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/system/system.h"

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
            ended_.notify_one();  // while the mutex is locked, as the waiting caller destroys this object
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

/// A thread that waits for calls.
class KeptThread {
  public:
    template <typename Serve>
    void start(const Serve& serve) {
        thread_ = std::thread(serve);
    }
    void assign(Calls& calls, int number) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            calls_ = &calls;
            number_ = number;
        }
        given_.notify_one();
    }
    /// @return true if the call was still queued; it will not run then
    bool withdraw(const Calls& calls) {
        const std::lock_guard<std::mutex> lock(mutex_);
        const bool waits = calls_ == &calls;
        calls_ = waits ? nullptr : calls_;
        return waits;
    }
    /// Waits for the next call. @return null at the end
    Calls* begin(int& number) {
        std::unique_lock<std::mutex> lock(mutex_);
        given_.wait(lock, [this] { return calls_ != nullptr || ended_; });
        number = number_;
        return std::exchange(calls_, nullptr);
    }
    void end() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            ended_ = true;
        }
        given_.notify_one();
        thread_.join();
    }

  private:
    std::thread thread_;
    std::mutex mutex_;
    std::condition_variable given_;
    Calls* calls_ = nullptr;  // null: no call waits to begin
    int number_ = 0;
    bool ended_ = false;
};

}  // namespace

class KeptThreads::Impl {
  public:
    explicit Impl(KeptThreads& owner) : owner_(owner) {}
    ~Impl() {
        for (const std::unique_ptr<KeptThread>& thread : all_) {
            thread->end();
        }
    }

    /// @return a thread that waits, else a new one
    /// @throws std::system_error, std::bad_alloc when there is none to be had
    KeptThread& waiting_or_new() {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!waiting_.empty()) {
            KeptThread& last = *waiting_.back();
            waiting_.pop_back();
            return last;
        }
        waiting_.reserve(all_.size() + 1);
        all_.push_back(std::make_unique<KeptThread>());
        KeptThread& fresh = *all_.back();
        try {
            fresh.start([this, &fresh] { serve(fresh); });
        } catch (...) {
            all_.pop_back();
            throw;
        }
        return fresh;
    }
    void keep(KeptThread& thread) {
        const std::lock_guard<std::mutex> lock(mutex_);
        waiting_.push_back(&thread);
    }

    // The mutex is locked while the process is copied, so that no other thread has it: threads do not survive the copy.
    void before_fork() { mutex_.lock(); }
    void after_fork() { mutex_.unlock(); }
    void after_fork_in_child() {
        waiting_.clear();
        for (std::unique_ptr<KeptThread>& thread : all_) {
            static_cast<void>(
                thread.release());  // The thread exists in the parent process only: the child cannot end it.
        }
        all_.clear();
        mutex_.unlock();
    }

  private:
    void serve(KeptThread& own) {
        const Member member(owner_);
        int number = 0;
        while (Calls* const calls = own.begin(number)) {
            calls->call(number);
            keep(own);  // before its caller is told, whose next call then finds it waiting
            calls->end_one();
        }
    }

    KeptThreads& owner_;
    std::mutex mutex_;
    std::vector<KeptThread*>
        waiting_;  // threads without a call; the last one in the list ended last, and its memory is in caches
    std::vector<std::unique_ptr<KeptThread>> all_;
};

KeptThreads::KeptThreads() : impl_(std::make_unique<Impl>(*this)) {}

KeptThreads::~KeptThreads() = default;

void KeptThreads::run(const std::function<void()>& work, const std::function<void()>& meanwhile) {
    const std::function<void(int)> call = [&](int /*number*/) { work(); };
    Calls calls(call);
    KeptThread& thread = impl_->waiting_or_new();
    calls.add();
    thread.assign(calls, 1);
    meanwhile();
    calls.wait();
}

KeptThreads& KeptThreads::of_process() {
    static KeptThreads& instance = []() -> KeptThreads& {
        at_fork([] { of_process().impl_->before_fork(); }, [] { of_process().impl_->after_fork(); },
                [] { of_process().impl_->after_fork_in_child(); });
        return *new KeptThreads();  // never destroyed: the threads wait while the process exits
    }();
    return instance;
}

void run_with_others(int others, const std::function<void(int)>& work) {
    KeptThreads* const own = KeptThreads::present();
    KeptThreads::Impl& threads = *(own != nullptr ? *own : KeptThreads::of_process()).impl_;
    Calls calls(work);
    std::vector<KeptThread*> given;
    given.reserve(static_cast<std::size_t>(std::max(0, others)));
    for (int number = 1; number <= others; ++number) {
        try {
            given.push_back(&threads.waiting_or_new());
        } catch (const std::system_error&) {
            break;  // the threads that could be started do the work
        } catch (const std::bad_alloc&) {
            break;
        }
        calls.add();
        given.back()->assign(calls, number);
    }
    work(0);
    for (KeptThread* thread : given) {
        if (thread->withdraw(calls)) {
            threads.keep(*thread);
            calls.end_one();
        }
    }
    calls.wait();
}

}  // namespace mq
