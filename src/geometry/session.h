// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/progress.h"
#include "geometry/engine.h"

namespace mq::geometry {

/// One model on one engine: the context in which an algorithm works on a model.
class Session {
  public:
    static constexpr std::size_t kPiece = 2048;  ///< queries in a piece: about 10 ms of B-spline projections

    Session(Engine& engine, std::shared_ptr<Model> model, const Progress* progress = nullptr)
        : engine_(engine), model_(std::move(model)), progress_(progress) {}

    const Topology& topology() const { return model_->topology(); }
    const RigidMotion& place() const { return model_->place(); }
    /// Answers in the batch's order. Large batches go to the engine in pieces, so that a cancelled operation ends soon
    /// and the engine stays open to others.
    /// @throws Cancelled.
    Engine::Answers ask(Engine::Batch batch) {
        check();
        if (batch.empty()) {
            return {};  // an empty batch does not wake the engine's thread
        }
        if (batch.size() <= kPiece) {
            return engine_.ask(model_, std::move(batch), progress_);
        }
        Engine::Answers all;
        all.reserve(batch.size());
        for (std::size_t from = 0; from < batch.size(); from += kPiece) {
            check();
            const auto first = batch.begin() + static_cast<std::ptrdiff_t>(from);
            const auto last = batch.begin() + static_cast<std::ptrdiff_t>(std::min(from + kPiece, batch.size()));
            Engine::Answers some = engine_.ask(model_, Engine::Batch(first, last), progress_);
            std::move(some.begin(), some.end(), std::back_inserter(all));
        }
        return all;
    }
    Answer ask(const Query& query) { return engine_.ask(model_, query, progress_); }
    /// Calls `work(model)` on the engine's thread.
    /// @throws Cancelled.
    template <typename Work>
    void run(const Work& work) {
        check();
        engine_.run([&] { work(*model_); }, progress_);
    }

    /// Calls `work(answerer, k)` for k = 0 .. count - 1, in no particular order, on as many threads as the caller may
    /// use, while the engine's thread waits for them. What a call gives must not depend on the calls before it.
    /// @throws as parallel_for
    template <typename Work>
    void run_parallel(int count, const Work& work) {
        const int most = std::min(count, thread_count());
        run([&](Model& model) {
            std::vector<Answerer*> answerers;
            for (Answerer* more = model.answerer(0); more != nullptr && static_cast<int>(answerers.size()) < most;
                 more = model.answerer(static_cast<int>(answerers.size()))) {
                answerers.push_back(more);
            }
            std::atomic<int> next{0};
            const ThreadLimit limit(static_cast<int>(answerers.size()));
            parallel_for(static_cast<int>(answerers.size()), [&](int thread) {
                for (int k = next++; k < count; k = next++) {
                    work(*answerers[static_cast<std::size_t>(thread)], k);
                }
            });
        });
    }

    /// @throws Cancelled
    void check() const { check_cancelled(progress_); }

  private:
    Engine& engine_;
    std::shared_ptr<Model> model_;
    const Progress* progress_;
};

}  // namespace mq::geometry
