// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "geometry/engine.h"
#include "geometry/model.h"

namespace mq::geometry {

/// The object that answers the queries of an algorithm in one thread: a Session, or one of several answerers.
class Oracle {
  public:
    virtual ~Oracle() = default;
    virtual const Topology& topology() const = 0;
    /// Answers in the batch's order.
    /// @throws Cancelled
    virtual Engine::Answers ask(Engine::Batch batch) = 0;
    virtual Answer ask(const Query& query) = 0;
    /// @throws Cancelled
    virtual void check() const = 0;
};

/// Asks an answerer in the calling thread, one of the engine's, while its main thread waits: in the calls of
/// Session::run_parallel.
class AnswererOracle final : public Oracle {
  public:
    AnswererOracle(const Topology& topology, Answerer& answerer, const Progress* progress)
        : topology_(topology), answerer_(answerer), progress_(progress) {}

    const Topology& topology() const override { return topology_; }
    Engine::Answers ask(Engine::Batch batch) override {
        // Queries between two checks for a cancellation: about 10 ms of B-spline projections.
        constexpr std::size_t kBetweenChecks = 2048;
        Engine::Answers answers;
        answers.reserve(batch.size());
        for (const Query& query : batch) {
            if (answers.size() % kBetweenChecks == 0) {
                check();
            }
            answers.push_back(answerer_.answer(query));
        }
        return answers;
    }
    Answer ask(const Query& query) override { return answerer_.answer(query); }
    void check() const override { check_cancelled(progress_); }

  private:
    const Topology& topology_;
    Answerer& answerer_;
    const Progress* progress_;
};

}  // namespace mq::geometry
