// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <thread>
#include <vector>

#include "base/predicates.h"
#include "base/threads/kept_threads.h"
#include "base/threads/schedule_hooks.h"

namespace mq {

/// Lets parallel_for use at most this number of threads when it is called by this thread, while the object lives.
class ThreadLimit {
  public:
    /// @param most  0: as many as without this object
    explicit ThreadLimit(int most) : before_(present()) { present() = most > 0 ? most : before_; }
    ~ThreadLimit() { present() = before_; }
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

    /// The limit of this thread; 0: there is none.
    static int& present() {
        thread_local int most = 0;
        return most;
    }

  private:
    int before_;
};

/// The number of threads that work at a time: the present ThreadLimit; else the value of the environment variable
/// MESHQUALITY_THREADS at the first call, if it is a number above 0; else the number of cores.
inline int thread_count() {
    if (ThreadLimit::present() > 0) {
        return ThreadLimit::present();
    }
    static const int count = [] {
        const char* said = std::getenv("MESHQUALITY_THREADS");
        const int asked = said == nullptr ? 0 : std::atoi(said);
        return asked > 0 ? asked : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    }();
    return count;
}

/// The number of threads for work on items of which each thread should have `worth` at least, so that its start pays.
inline int threads_for(std::size_t items, std::size_t worth) {
    return static_cast<int>(std::clamp<std::size_t>(items / worth, 1, static_cast<std::size_t>(thread_count())));
}

/// Runs work(thread, k) for k = 0 .. count - 1 on thread_count() threads, in no particular order; `thread` counts from
/// 0, and no two calls have the same one at a time. Results must be written to places of their own, so that they do not
/// depend on the number of threads. Where there are more threads than calls, what the calls run in parallel themselves
/// shares the rest. Predicates count for the caller's thread.
/// @throws the exception of the call with the lowest k, once all threads have ended; calls not yet begun are left out
/// then
template <typename Work>
void parallel_for_on_threads(int count, Work&& work) {
    std::atomic<int> next{0};
    std::vector<std::exception_ptr> raised(static_cast<std::size_t>(count));
    const int all = thread_count();
    const int threads = std::min(count, all);
    const int inner = std::max(1, all / std::max(1, threads));
    std::vector<PredicateCount> decided(static_cast<std::size_t>(std::max(1, threads)));
    const ScheduleTrace::Section section(threads);
    const auto worker = [&](int thread) {
        const ThreadLimit limit(inner);
        if (thread > 0) {
            predicate_count() = {};  // the thread has worked for others before
        }
        for (int k = next++; k < count; k = next++) {
            const ScheduleTrace::Task task(section);
            try {
                work(thread, k);
            } catch (...) {
                raised[static_cast<std::size_t>(k)] = std::current_exception();
                next = count;
            }
        }
        decided[static_cast<std::size_t>(thread)] = predicate_count();
    };
    run_with_others(section.recorded() ? 0 : threads - 1, worker);
    for (int i = 1; i < threads; ++i) {
        predicate_count() += decided[static_cast<std::size_t>(i)];
    }
    for (const std::exception_ptr& exception : raised) {
        if (exception) {
            std::rethrow_exception(exception);
        }
    }
}

/// Runs work(k) for k = 0 .. count - 1, as parallel_for_on_threads does.
template <typename Work>
void parallel_for(int count, Work&& work) {
    parallel_for_on_threads(count, [&](int /*thread*/, int k) { work(k); });
}

/// Runs work(k) for k = 0 .. count - 1 in parallel, a chunk of neighbours at a time, so that short calls pay; in this
/// thread where there is one chunk only.
/// @throws as parallel_for
template <typename Work>
void for_chunks(int count, const Work& work) {
    // Calls in a chunk: enough of them that starting it costs little.
    constexpr int kChunk = 64;
    parallel_for((count + kChunk - 1) / kChunk, [&](int i) {
        const int end = std::min((i + 1) * kChunk, count);
        for (int k = i * kChunk; k < end; ++k) {
            work(k);
        }
    });
}

/// parallel_for for calls that take less than a microsecond: on so few threads that each has at least `worth` calls.
/// @throws as parallel_for
template <typename Work>
void for_chunks(int count, int worth, const Work& work) {
    const ThreadLimit limit(threads_for(static_cast<std::size_t>(count), static_cast<std::size_t>(worth)));
    for_chunks(count, work);
}

}  // namespace mq
