// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/engine.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "base/predicates.h"
#include "base/threads/kept_threads.h"
#include "base/waits.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/engine_gate.h"

namespace mq::geometry {

namespace {

Engine::Answers stopped(std::size_t count) {
    Answer answer;
    answer.status = Status::Stopped;
    return Engine::Answers(count, answer);
}

/// A job in the engine's queue: a batch, or the work of a call of `run` when `work` is set.
struct Job {
    std::shared_ptr<Model> model;
    Engine::Batch batch;
    std::promise<Engine::Answers> answers;
    const std::function<void()>* work = nullptr;
    std::promise<void> done;
    const Progress* owner = nullptr;  ///< progress of the caller, who waits until the job has ended
    std::uint64_t generation = 0;
    std::uint64_t number = 0;  ///< number among all jobs of the engine, in the order of their arrival
};

/// Time between two checks whether a waiting caller was cancelled: much less than the 0.2 s that users may notice.
constexpr std::chrono::milliseconds kPollInterval(20);

bool is_cancelled(const Progress* progress) {
    return progress != nullptr && progress->cancelled();
}

/// Makes another thread work for the one that made this object and waits for it: its predicates are counted there, and
/// the limit of threads is the same.
class ForCaller {
  public:
    void run(const std::function<void()>& work) const {
        const ThreadLimit limit(threads_);
        const Counting counting(count_);
        work();
    }

  private:
    class Counting {
      public:
        explicit Counting(PredicateCount& callers)
            : callers_(callers), own_(std::exchange(predicate_count(), callers)) {}
        ~Counting() { callers_ = std::exchange(predicate_count(), own_); }
        Counting(const Counting&) = delete;
        Counting& operator=(const Counting&) = delete;

      private:
        PredicateCount& callers_;
        PredicateCount own_;
    };

    PredicateCount& count_ = predicate_count();
    int threads_ = thread_count();
};

}  // namespace

Cancelled engine_has_ended() {
    return Cancelled(phrases::kEngineEnded);
}

class Engine::Impl {
  public:
    Impl(Mode mode, std::size_t capacity) : mode_(mode), capacity_(capacity > 0 ? capacity : 1) {}
    ~Impl();
    std::future<Answers> submit(const std::shared_ptr<Model>& model, Batch batch);
    Answers ask(const std::shared_ptr<Model>& model, Batch batch, const Progress* progress);
    void run(const std::function<void()>& work, const Progress* progress);
    void run_job(EngineGate& gate, const std::function<void()>& work, const Progress* progress);
    void check_own_thread() const;
    void cancel();
    void shut_down();
    std::uint64_t queries() const { return queries_.load(std::memory_order_relaxed); }
    void count_answered(std::uint64_t queries) { queries_.fetch_add(queries, std::memory_order_relaxed); }

  private:
    bool on_main_thread() const { return std::this_thread::get_id() == worker_id_.load(); }
    void refuse_jobs() const;
    void keep_open(EngineGate& gate, const Progress* progress);
    bool push(Job& job, const Progress* progress);
    std::future<Answers> hand_over(Job& job, const Progress* progress);
    template <typename Result>
    bool wait(const std::future<Result>& result, std::uint64_t number, const Progress* progress,
              const EngineGate* gate = nullptr);
    void stay_at(EngineGate& gate);
    bool withdraw(std::uint64_t number);
    void name_user(std::uint64_t number, const Progress* progress);
    std::deque<Job>::iterator waiting_job(std::uint64_t number);
    void serve();
    void finish(Job& job);
    Answers answer(const std::shared_ptr<Model>& model, const Batch& batch, std::uint64_t generation);
    void drop_waiting(bool with_work);

    const Mode mode_;
    const std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable not_empty_;
    std::condition_variable not_full_;
    std::deque<Job> queue_;
    std::uint64_t jobs_ = 0;
    std::string user_;            ///< title of the operation whose job runs
    EngineGate* gate_ = nullptr;  ///< at which the thread waits
    bool stopping_ = false;
    std::mutex join_mutex_;
    std::thread worker_;
    std::atomic<std::thread::id> worker_id_{};
    /// Counts the cancellations: a batch is answered only while the count is the one it was submitted under.
    std::atomic<std::uint64_t> generation_{0};
    std::atomic<std::uint64_t> queries_{0};
    KeptThreads
        threads_;  ///< the main thread is one of them; last member, so that they end before the members that they use
};

Engine::Impl::~Impl() {
    shut_down();
}

/// Waits for room in the queue, and numbers the job.
/// @returns false, with the job untouched, when the engine is or gets shut down.
/// @throws Cancelled
bool Engine::Impl::push(Job& job, const Progress* progress) {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!not_full_.wait_for(lock, kPollInterval, [this] { return stopping_ || queue_.size() < capacity_; })) {
        check_cancelled(progress);
    }
    if (stopping_) {
        return false;
    }
    job.number = ++jobs_;
    if (!worker_.joinable()) {
        worker_ = std::thread([this] { serve(); });
    }
    queue_.push_back(std::move(job));
    if (gate_ != nullptr) {
        gate_->let_through();
    }
    lock.unlock();
    not_empty_.notify_one();
    return true;
}

/// Waits for the result of a job, which is withdrawn when the caller is cancelled, or the gate that it opens is closed,
/// before its turn has come.
/// @returns false when the job is withdrawn because of the gate.
/// @throws Cancelled
template <typename Result>
bool Engine::Impl::wait(const std::future<Result>& result, std::uint64_t number, const Progress* progress,
                        const EngineGate* gate) {
    while (result.wait_for(kPollInterval) != std::future_status::ready) {
        const bool closed = gate != nullptr && gate->closed();
        if ((closed || is_cancelled(progress)) && withdraw(number)) {
            check_cancelled(progress);
            return false;
        }
        name_user(number, progress);
    }
    return true;
}

/// Tells the caller which operation's job it waits for, as long as its own job is in the queue.
void Engine::Impl::name_user(std::uint64_t number, const Progress* progress) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (waiting_job(number) != queue_.end()) {
        const Message name = user_.empty() ? Message(phrases::kOtherWork) : Message::value(user_);
        Waits::set(progress, Message(phrases::kWaitsForEngine, {{"name", name}}));
    }
}

/// Requires the mutex to be held.
std::deque<Job>::iterator Engine::Impl::waiting_job(std::uint64_t number) {
    return std::find_if(queue_.begin(), queue_.end(), [&](const Job& job) { return job.number == number; });
}

/// Removes a job from the queue. @returns false when it is not in the queue any more.
bool Engine::Impl::withdraw(std::uint64_t number) {
    Job withdrawn;  // released after the lock
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = waiting_job(number);
    if (found == queue_.end()) {
        return false;
    }
    withdrawn = std::move(*found);
    queue_.erase(found);
    not_full_.notify_one();
    return true;
}

void Engine::Impl::serve() {
    const KeptThreads::Member member(threads_);
    worker_id_.store(std::this_thread::get_id());
    for (;;) {
        std::unique_lock<std::mutex> lock(mutex_);
        not_empty_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
        if (queue_.empty()) {
            // The system may give this thread's id to another one after its end.
            worker_id_.store(std::thread::id());
            return;
        }
        Job job = std::move(queue_.front());
        queue_.pop_front();
        user_ = Waits::title_of(job.owner);
        Waits::set(job.owner, Message());
        lock.unlock();
        not_full_.notify_one();
        finish(job);
    }
}

void Engine::Impl::finish(Job& job) {
    if (job.work != nullptr) {
        try {
            (*job.work)();
            job.done.set_value();
        } catch (...) {  // passed on, whatever it is: it is thrown again in the caller's thread
            job.done.set_exception(std::current_exception());
        }
        return;
    }
    Answers answers;
    {
        const OpenCascadeWait wait(job.owner, job.owner != nullptr ? job.owner->name() : std::string());
        answers = answer(job.model, job.batch, job.generation);
    }
    // The caller who has the answers may be the last owner of the model then.
    job.model.reset();
    job.answers.set_value(std::move(answers));
}

Engine::Answers Engine::Impl::answer(const std::shared_ptr<Model>& model, const Batch& batch,
                                     std::uint64_t generation) {
    Answers answers;
    answers.reserve(batch.size());
    std::size_t count = 0;
    for (; count < batch.size() && generation_.load(std::memory_order_relaxed) == generation; ++count) {
        if (model) {
            answers.push_back(model->answer(batch[count]));
        } else {
            answers.emplace_back();
            answers.back().status = Status::BadQuery;
        }
    }
    answers.resize(batch.size());  // queries that were stopped keep the default answer
    count_answered(count);
    return answers;
}

std::future<Engine::Answers> Engine::Impl::submit(const std::shared_ptr<Model>& model, Batch batch) {
    Job job;
    job.model = model;
    job.batch = std::move(batch);
    return hand_over(job, nullptr);
}

Engine::Answers Engine::Impl::ask(const std::shared_ptr<Model>& model, Batch batch, const Progress* progress) {
    Job job;
    job.model = model;
    job.batch = std::move(batch);
    job.owner = progress;
    std::future<Answers> answers = hand_over(job, progress);
    wait(answers, job.number, progress);
    return answers.get();
}

/// Answers a batch; the job keeps its number.
std::future<Engine::Answers> Engine::Impl::hand_over(Job& job, const Progress* progress) {
    refuse_jobs();
    job.generation = generation_.load();
    std::future<Answers> future = job.answers.get_future();
    if (mode_ == Mode::Direct) {
        std::unique_lock<std::mutex> lock(mutex_);
        const bool refused = stopping_;
        lock.unlock();
        job.answers.set_value(refused ? stopped(job.batch.size()) : answer(job.model, job.batch, job.generation));
    } else if (on_main_thread()) {
        // Waiting for the queue on the engine's main thread would never end.
        finish(job);
    } else if (!push(job, progress)) {
        job.answers.set_value(stopped(job.batch.size()));
    }
    return future;
}

void Engine::Impl::run(const std::function<void()>& work, const Progress* progress) {
    if (mode_ == Mode::Direct || on_main_thread()) {
        work();
        return;
    }
    refuse_jobs();
    const ForCaller caller;
    const std::function<void()> for_caller = [&] { caller.run(work); };
    Job job;
    job.work = &for_caller;
    job.owner = progress;
    std::future<void> done = job.done.get_future();
    if (!push(job, progress)) {
        throw engine_has_ended();
    }
    wait(done, job.number, progress);
    done.get();
}

void Engine::Impl::run_job(EngineGate& gate, const std::function<void()>& work, const Progress* progress) {
    if (threads_.own_this_thread()) {
        throw std::logic_error("a job of the geometry engine cannot begin another one, for which it would wait");
    }
    const ForCaller caller;
    std::exception_ptr raised;
    std::exception_ptr failure;
    threads_.run(
        [&] {
            try {
                caller.run(work);
            } catch (...) {
                raised = std::current_exception();
            }
            gate.close();
        },
        [&] {
            try {
                keep_open(gate, progress);
            } catch (...) {
                failure = std::current_exception();  // thrown again below if the work failed for lack of answers
                gate.close();
            }
        });
    if (raised) {
        std::rethrow_exception(failure ? failure : raised);
    }
}

void Engine::Impl::check_own_thread() const {
    if (mode_ == Mode::Threaded && !threads_.own_this_thread()) {
        throw std::logic_error("models of the geometry engine are asked on its own threads: this is none of them");
    }
}

/// @throws std::logic_error on the thread of a job
void Engine::Impl::refuse_jobs() const {
    if (threads_.own_this_thread() && !on_main_thread()) {
        throw std::logic_error("a job of the geometry engine would wait for itself: it must ask its own session");
    }
}

/// Opens the gate on the engine's main thread whenever nobody else needs it, until the gate is closed.
/// @throws Cancelled
void Engine::Impl::keep_open(EngineGate& gate, const Progress* progress) {
    const std::function<void()> work = [&] { stay_at(gate); };
    if (mode_ == Mode::Direct) {
        work();
        return;
    }
    while (!gate.closed()) {
        Job job;
        job.work = &work;
        job.owner = progress;
        std::future<void> done = job.done.get_future();
        if (!push(job, progress)) {
            throw engine_has_ended();
        }
        if (wait(done, job.number, progress, &gate)) {
            done.get();
        }
    }
}

/// On the engine's main thread: waits at the gate until somebody else has a job.
void Engine::Impl::stay_at(EngineGate& gate) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        gate_ = &gate;
        if (!queue_.empty()) {
            gate.let_through();
        }
    }
    gate.open();
    const std::lock_guard<std::mutex> lock(mutex_);
    gate_ = nullptr;
}

void Engine::Impl::drop_waiting(bool with_work) {
    std::deque<Job> dropped;
    {
        std::lock_guard<std::mutex> lock(mutex_);
        std::deque<Job> kept;
        for (Job& job : queue_) {
            (job.work != nullptr && !with_work ? kept : dropped).push_back(std::move(job));
        }
        queue_.swap(kept);
    }
    not_full_.notify_all();
    for (Job& job : dropped) {
        if (job.work != nullptr) {
            job.done.set_exception(std::make_exception_ptr(engine_has_ended()));
        } else {
            job.model.reset();
            job.answers.set_value(stopped(job.batch.size()));
        }
    }
}

void Engine::Impl::cancel() {
    generation_.fetch_add(1);
    drop_waiting(false);
}

void Engine::Impl::shut_down() {
    {
        std::lock_guard<std::mutex> lock(mutex_);
        stopping_ = true;
        if (gate_ != nullptr) {
            gate_->let_through();
        }
    }
    generation_.fetch_add(1);
    drop_waiting(true);
    not_empty_.notify_all();
    if (!on_main_thread()) {
        std::lock_guard<std::mutex> lock(join_mutex_);
        if (worker_.joinable()) {
            worker_.join();
        }
    }
}

Engine::Engine(Mode mode, std::size_t queue_capacity) : impl_(std::make_unique<Impl>(mode, queue_capacity)) {}

Engine::~Engine() = default;

std::future<Engine::Answers> Engine::submit(const std::shared_ptr<Model>& model, Batch batch) {
    return impl_->submit(model, std::move(batch));
}

Engine::Answers Engine::ask(const std::shared_ptr<Model>& model, Batch batch, const Progress* progress) {
    return impl_->ask(model, std::move(batch), progress);
}

Answer Engine::ask(const std::shared_ptr<Model>& model, const Query& query, const Progress* progress) {
    return impl_->ask(model, Batch{query}, progress).front();
}

void Engine::run(const std::function<void()>& work, const Progress* progress) {
    impl_->run(work, progress);
}

void Engine::run_job(EngineGate& gate, const std::function<void()>& work, const Progress* progress) {
    impl_->run_job(gate, work, progress);
}

void Engine::check_own_thread() const {
    impl_->check_own_thread();
}

void Engine::cancel() {
    impl_->cancel();
}

void Engine::shut_down() {
    impl_->shut_down();
}

std::uint64_t Engine::queries() const {
    return impl_->queries();
}

void Engine::count_answered(std::uint64_t queries) {
    impl_->count_answered(queries);
}

}  // namespace mq::geometry
