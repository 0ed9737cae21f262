// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "geometry/model.h"

namespace mq::geometry {

class EngineGate;

/// The geometry engine, whose threads alone ask the modeler: a main one, which answers batches of queries in the order
/// they came, and those of the jobs, to which it gives the modeler in turns (`run_job`).
///
/// Several models can be served at once and several threads may ask. The queue is bounded: `submit` waits while it is
/// full. After `shut_down` every query is answered with Status::Stopped. Work on the engine's threads counts its
/// predicates for the caller, who waits for it, and the caller's ThreadLimit holds; what it runs in parallel runs on
/// the engine's threads, too.
class Engine {
  public:
    enum class Mode {
        Threaded,  ///< the modeler lives on threads of the engine's own
        Direct,    ///< queries outside of jobs are answered in the caller's thread (for comparisons; one caller only)
    };
    explicit Engine(Mode mode = Mode::Threaded, std::size_t queue_capacity = 64);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    using Batch = std::vector<Query>;
    using Answers = std::vector<Answer>;

    /// Submits a batch and returns at once; the answers come in the batch's order.
    std::future<Answers> submit(const std::shared_ptr<Model>& model, Batch batch);
    /// Submits a batch and waits for its answers. A batch whose turn has not come is withdrawn once `progress` is
    /// cancelled.
    /// @throws Cancelled
    Answers ask(const std::shared_ptr<Model>& model, Batch batch, const Progress* progress = nullptr);
    Answer ask(const std::shared_ptr<Model>& model, const Query& query, const Progress* progress = nullptr);

    /// Runs `work` on the engine's main thread and waits for it, for example to build a model. Exceptions of `work` are
    /// thrown again in the caller's thread. Work that has not begun is withdrawn once `progress` is cancelled.
    /// @throws Cancelled; std::logic_error on a job's thread, which would wait for itself
    void run(const std::function<void()>& work, const Progress* progress = nullptr);

    /// Runs `work` on a thread of the engine for jobs and waits for it. It asks models only within entries of the gate,
    /// which the engine's main thread opens whenever nobody else needs it, until the job has ended. Exceptions of
    /// `work` are thrown again in the caller's thread.
    /// @throws Cancelled, when that is why an entry was refused; std::logic_error on one of the engine's threads;
    /// std::system_error where there is no thread to be had
    void run_job(EngineGate& gate, const std::function<void()>& work, const Progress* progress = nullptr);

    /// To be called before models are asked.
    /// @throws std::logic_error on a thread that the engine does not own; never in Mode::Direct
    void check_own_thread() const;

    /// Cancels all batches in the queue; they and the rest of the running one are answered with Status::Stopped.
    void cancel();
    /// Cancels all batches as cancel() does, and ends the main thread; threads of jobs end with the object. Idempotent.
    void shut_down();

    /// The number of queries answered since the start.
    std::uint64_t queries() const;
    /// Adds queries that the work of `run` and jobs have answered to that number.
    void count_answered(std::uint64_t queries);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace mq::geometry
