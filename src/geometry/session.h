// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/progress.h"
#include "base/waits.h"
#include "geometry/engine.h"
#include "geometry/engine_gate.h"
#include "geometry/oracle.h"

namespace mq::geometry {

/// One model on one engine: the context in which an algorithm works on a model. The engine's main thread answers, or,
/// in the sessions of `in_place` and `run_apart`, the threads that ask, which are the engine's, too.
class Session final : public Oracle {
  public:
    /// Items in a chunk, which one thread takes at a time: 0.1 ms of work or more, so that starting a thread pays.
    static constexpr std::size_t kChunk = 256;
    /// Time after which the engine's main thread is to be open to others: much less than users may notice.
    static constexpr std::chrono::milliseconds kOpenAfter{20};

    Session(Engine& engine, std::shared_ptr<Model> model, const Progress* progress = nullptr)
        : engine_(engine), model_(std::move(model)), progress_(progress) {}

    const Topology& topology() const override { return model_->topology(); }
    const RigidMotion& place() const { return model_->place(); }
    /// Answers in the batch's order. Large batches are answered by several threads, and in pieces, so that a cancelled
    /// operation ends soon and the engine stays open to others.
    /// @throws Cancelled.
    Engine::Answers ask(Engine::Batch batch) override {
        check();
        if (batch.empty()) {
            return {};  // an empty batch does not wake the engine's main thread
        }
        if (batch.size() <= kChunk && answerers_ == nullptr) {
            return engine_.ask(model_, std::move(batch), progress_);
        }
        Engine::Answers all(batch.size());
        for_chunks(batch.size(), [&](Answerer& answerer, std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                all[i] = answerer.answer(batch[i]);
            }
        });
        return all;
    }
    Answer ask(const Query& query) override {
        if (answerers_ == nullptr) {
            return engine_.ask(model_, query, progress_);
        }
        const EngineGate::Entry entry = enter();
        return answerers_->answer(query);
    }
    /// Calls `work(model)` while nobody else asks: on the engine's main thread, or in the calling thread in a session
    /// of `in_place`. It asks nothing but the model.
    /// @throws Cancelled, std::logic_error in a session of run_apart
    template <typename Work>
    void run(const Work& work) {
        check();
        if (answerers_ != nullptr) {
            if (apart_) {
                throw std::logic_error("a session of run_apart cannot have the model for itself");
            }
            const EngineGate::Entry entry = enter();
            work(*model_);
            return;
        }
        engine_.run([&] { work(*model_); }, progress_);
    }

    /// Calls `work(session)` on a thread of the engine for jobs, with a session that answers in the threads that ask,
    /// and waits for it: handing a small batch from thread to thread takes longer than its answers. What `work` runs in
    /// parallel runs on the engine's threads, too. The engine is open to others between questions, or pieces of large
    /// batches.
    /// @throws Cancelled, and what `work` throws; std::logic_error on the engine's threads, or without an answerer
    template <typename Work>
    void in_place(const Work& work) {
        std::vector<CountingAnswerer> answerers;
        run([&](Model& model) { answerers = answerers_of(model, thread_count()); });
        if (answerers.empty()) {
            throw std::logic_error("the model has no answerer");
        }
        EngineGate gate;
        const auto count = [&] {
            for (const CountingAnswerer& answerer : answerers) {
                engine_.count_answered(answerer.count());
            }
        };
        try {
            engine_.run_job(
                gate,
                [&] {
                    Session own(*this, answerers.data(), static_cast<int>(answerers.size()), gate, false);
                    work(own);
                },
                progress_);
        } catch (...) {
            count();
            throw;
        }
        count();
    }
    /// Returns how many queries a session of `in_place` has answered.
    std::uint64_t queries() const {
        std::uint64_t sum = 0;
        std::for_each(answerers_, answerers_ + count_, [&](const CountingAnswerer& one) { sum += one.count(); });
        return sum;
    }

    /// Calls `work(answerer, k)` for k = 0 .. count - 1, in no particular order, on as many of the engine's threads as
    /// the caller may use, while the main one waits for them. What a call gives must not depend on the calls before it;
    /// calls ask nothing but the answerer.
    /// @throws as parallel_for
    template <typename Work>
    void run_parallel(int count, const Work& work) {
        if (answerers_ != nullptr) {
            const EngineGate::Entry entry = enter();
            std::optional<OpenCascadeWait> wait;
            if (count > 1 && !apart_) {  // for one chunk, saying that it waits would take longer than the answers
                wait.emplace(progress_, progress_ != nullptr ? progress_->name() : std::string());
            }
            call_with(answerers_, count_, count, work);
            return;
        }
        const int most = std::min(count, thread_count());
        run([&](Model& model) {
            std::vector<CountingAnswerer> answerers = answerers_of(model, most);
            const OpenCascadeWait wait(progress_, progress_ != nullptr ? progress_->name() : std::string());
            call_with(answerers.data(), static_cast<int>(answerers.size()), count, work);
            for (const CountingAnswerer& answerer : answerers) {
                engine_.count_answered(answerer.count());
            }
        });
    }

    /// Calls `work(session, k)` for k = 0 .. count - 1, in no particular order, on as many of the engine's threads as
    /// the caller may use. A call asks its own session, which answers in the call's thread, as in `in_place`.
    /// @throws as parallel_for
    template <typename Work>
    void run_apart(int count, const Work& work) {
        if (answerers_ == nullptr) {
            in_place([&](Session& own) { own.run_apart(count, work); });
            return;
        }
        const ThreadLimit limit(std::min(count_, thread_count()));
        parallel_for_on_threads(count, [&](int thread, int k) {
            Session apart(*this, answerers_ + thread, 1, *gate_, true);
            work(apart, k);
        });
    }

    /// Calls `work(answerer, from, to)` for chunks of the items 0 .. count - 1, as run_parallel does. The engine is
    /// open to others after each piece of the work.
    /// @param queries  about how many an item asks
    /// @throws as parallel_for
    template <typename Work>
    void for_chunks(std::size_t count, const Work& work, std::size_t queries = 1) {
        // Chunks of a thread in a piece: B-spline projections take about kOpenAfter.
        constexpr std::size_t kChunksOfThread = 16;
        const std::size_t chunk = std::max<std::size_t>(1, kChunk / queries);
        const int threads = answerers_ != nullptr ? std::min(count_, thread_count()) : thread_count();
        const std::size_t piece = chunk * kChunksOfThread * static_cast<std::size_t>(threads);
        for (std::size_t begin = 0; begin < count; begin += piece) {
            const std::size_t end = std::min(begin + piece, count);
            run_parallel(static_cast<int>((end - begin + chunk - 1) / chunk), [&](Answerer& answerer, int k) {
                check();
                const std::size_t from = begin + static_cast<std::size_t>(k) * chunk;
                work(answerer, from, std::min(from + chunk, end));
            });
        }
    }

    /// @throws Cancelled
    void check() const override { check_cancelled(progress_); }

  private:
    /// Before the model is asked in a session of `in_place` or `run_apart`.
    /// @throws std::logic_error on a thread that is not the engine's; Cancelled
    EngineGate::Entry enter() const {
        engine_.check_own_thread();
        return EngineGate::Entry(*gate_);
    }

    /// Counts the queries that another object answers. Each has cache lines of its own, since each counts in its own
    /// thread.
    class alignas(64) CountingAnswerer final : public Answerer {
      public:
        explicit CountingAnswerer(Answerer& other) : other_(other) {}
        Answer answer(const Query& query) noexcept override {
            ++count_;
            return other_.answer(query);
        }
        std::uint64_t count() const { return count_; }

      private:
        Answerer& other_;
        std::uint64_t count_ = 0;
    };

    Session(const Session& session, CountingAnswerer* answerers, int count, EngineGate& gate, bool apart)
        : engine_(session.engine_),
          model_(session.model_),
          progress_(session.progress_),
          answerers_(answerers),
          count_(count),
          gate_(&gate),
          apart_(apart) {}

    // Calls `work(answerer, k)` for k = 0 .. count - 1, each thread with an answerer of its own.
    template <typename Work>
    void call_with(CountingAnswerer* answerers, int most, int count, const Work& work) const {
        const ThreadLimit limit(std::min(most, thread_count()));
        parallel_for_on_threads(count, [&](int thread, int k) {
            engine_.check_own_thread();
            work(answerers[thread], k);
        });
    }

    static std::vector<CountingAnswerer> answerers_of(Model& model, int most) {
        std::vector<CountingAnswerer> answerers;
        while (static_cast<int>(answerers.size()) < most) {
            Answerer* const more = model.answerer(static_cast<int>(answerers.size()));
            if (more == nullptr) {
                break;
            }
            answerers.emplace_back(*more);
        }
        return answerers;
    }

    Engine& engine_;
    std::shared_ptr<Model> model_;
    const Progress* progress_;
    // By thread, in sessions of `in_place` and `run_apart`; null: the engine answers.
    CountingAnswerer* answerers_ = nullptr;
    int count_ = 0;
    EngineGate* gate_ = nullptr;
    bool apart_ = false;  // whether others ask meanwhile
};

}  // namespace mq::geometry
