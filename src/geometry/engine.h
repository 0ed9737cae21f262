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

/// The geometry engine: one thread that owns the modeler and answers batches of queries in the order they came.
///
/// Several models can be served at once and several threads may ask. The queue is bounded: `submit` waits while it is
/// full. After `shut_down` every query is answered with Status::Stopped.
class Engine {
  public:
    enum class Mode {
        Threaded,  ///< the modeler lives on a thread of the engine's own
        Direct,    ///< every query is answered in the caller's thread (for comparisons; one caller only)
    };
    explicit Engine(Mode mode = Mode::Threaded, std::size_t queue_capacity = 64);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    using Batch = std::vector<Query>;
    using Answers = std::vector<Answer>;

    /// Submits a batch and returns at once; the answers come in the batch's order.
    std::future<Answers> submit(const std::shared_ptr<Model>& model, Batch batch);
    /// The same, waiting for the answers. A batch whose turn has not come yet is withdrawn once `progress` is
    /// cancelled.
    /// @throws Cancelled
    Answers ask(const std::shared_ptr<Model>& model, Batch batch, const Progress* progress = nullptr);
    Answer ask(const std::shared_ptr<Model>& model, const Query& query, const Progress* progress = nullptr);

    /// Runs `work` on the engine's thread and waits for it, for example to build a model. Exceptions of `work` are
    /// thrown again in the caller's thread. Work that has not begun is withdrawn once `progress` is cancelled.
    /// @throws Cancelled
    void run(const std::function<void()>& work, const Progress* progress = nullptr);

    /// Opens the gate on the engine's thread whenever nobody else needs it, until the gate is closed.
    /// @throws Cancelled
    void keep_open(EngineGate& gate, const Progress* progress = nullptr);
    /// Whether the calling thread is the engine's.
    bool on_own_thread() const;

    /// Drops all batches in the queue; they and the rest of the running one are answered with Status::Stopped.
    void cancel();
    /// As cancel, and the thread ends. Idempotent.
    void shut_down();

    /// The number of queries answered since the start.
    std::uint64_t queries() const;
    /// Adds queries that the work of `run` and threads at a gate have answered to that number.
    void count_answered(std::uint64_t queries);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace mq::geometry
