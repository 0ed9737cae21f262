// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/predicates.h"
#include "base/progress.h"
#include "base/waits.h"
#include "geometry/engine.h"
#include "geometry/engine_gate.h"
#include "geometry/oracle.h"

namespace mq::geometry {

/// One model on one engine: the context in which an algorithm works on a model.
class Session final : public Oracle {
  public:
    /// Items in a chunk, which one thread takes at a time: 0.1 ms of work or more, so that starting a thread pays.
    static constexpr std::size_t kChunk = 256;
    /// Time after which the engine's thread is to be open to others: much less than users may notice.
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
            return {};  // an empty batch does not wake the engine's thread
        }
        if (batch.size() <= kChunk && answerer_ == nullptr) {
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
        if (answerer_ == nullptr) {
            return engine_.ask(model_, query, progress_);
        }
        const EngineGate::Entry entry(gate_);
        return answerer_->answer(query);
    }
    /// Calls `work(model)` on the engine's thread. Predicates count for the caller's, whose limit of threads holds.
    /// @throws Cancelled, std::logic_error in a session of run_apart
    template <typename Work>
    void run(const Work& work) {
        if (answerer_ != nullptr) {
            throw std::logic_error("a session of run_apart does not reach the engine's thread");
        }
        check();
        PredicateCount& callers = predicate_count();
        const int threads = thread_count();
        engine_.run(
            [&] {
                const ThreadLimit limit(threads);
                const CountForCaller count(callers);
                work(*model_);
            },
            progress_);
    }

    /// Repeats a step as long as it returns true, on the engine's thread, which is open to others after each step that
    /// ends kOpenAfter or more after the last opening. So the batches of a step are answered in place: handing a small
    /// one from thread to thread takes longer than its answers. In a session of run_apart: in the calling thread.
    /// @throws Cancelled.
    template <typename Step>
    void repeat(const Step& step) {
        using Clock = std::chrono::steady_clock;
        for (bool more = true; more;) {
            if (answerer_ != nullptr) {
                more = step();
                continue;
            }
            run([&](Model&) {
                for (const Clock::time_point end = Clock::now() + kOpenAfter; more && Clock::now() < end;) {
                    more = step();
                }
            });
        }
    }

    /// Calls `work(answerer, k)` for k = 0 .. count - 1, in no particular order, on as many threads as the caller may
    /// use, while the engine's thread waits for them. What a call gives must not depend on the calls before it.
    /// @throws as parallel_for
    template <typename Work>
    void run_parallel(int count, const Work& work) {
        const int most = std::min(count, thread_count());
        run([&](Model& model) {
            std::vector<CountingAnswerer> answerers = answerers_of(model, most);
            const OpenCascadeWait wait(progress_, progress_ != nullptr ? progress_->name() : std::string());
            const ThreadLimit limit(static_cast<int>(answerers.size()));
            parallel_for_on_threads(count,
                                    [&](int thread, int k) { work(answerers[static_cast<std::size_t>(thread)], k); });
            for (const CountingAnswerer& answerer : answerers) {
                engine_.count_answered(answerer.count());
            }
        });
    }

    /// Calls `work(session, k)` for k = 0 .. count - 1, in no particular order, on as many threads as the caller may
    /// use. A call asks its own session, which answers in the call's thread; `run` must not be called there. The
    /// engine is open to others every kOpenAfter. Not to be called on the engine's thread.
    /// @throws as parallel_for
    template <typename Work>
    void run_apart(int count, const Work& work) {
        std::vector<CountingAnswerer> answerers;
        run([&](Model& model) { answerers = answerers_of(model, std::min(count, thread_count())); });
        EngineGate gate;
        std::exception_ptr failure;
        std::thread keeper([&] {
            try {
                for (bool more = true; more;) {
                    run([&](Model&) {
                        const OpenCascadeWait wait(progress_, progress_ != nullptr ? progress_->name() : "");
                        more = gate.open_for(kOpenAfter);
                    });
                }
            } catch (...) {
                failure = std::current_exception();  // Thrown again below.
                gate.close();
            }
        });
        std::exception_ptr raised;
        try {
            const ThreadLimit limit(static_cast<int>(answerers.size()));
            parallel_for_on_threads(count, [&](int thread, int k) {
                Session apart(*this, answerers[static_cast<std::size_t>(thread)], gate);
                work(apart, k);
            });
        } catch (...) {
            raised = std::current_exception();
        }
        gate.close();
        keeper.join();
        for (const CountingAnswerer& answerer : answerers) {
            engine_.count_answered(answerer.count());
        }
        if (failure || raised) {
            std::rethrow_exception(failure ? failure : raised);
        }
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
        const std::size_t piece = chunk * kChunksOfThread * static_cast<std::size_t>(thread_count());
        for (std::size_t begin = 0; begin < count; begin += piece) {
            const std::size_t end = std::min(begin + piece, count);
            const int chunks = static_cast<int>((end - begin + chunk - 1) / chunk);
            const auto one = [&](Answerer& answerer, int k) {
                check();
                const std::size_t from = begin + static_cast<std::size_t>(k) * chunk;
                work(answerer, from, std::min(from + chunk, end));
            };
            if (answerer_ == nullptr) {
                run_parallel(chunks, one);
                continue;
            }
            for (int k = 0; k < chunks; ++k) {
                const EngineGate::Entry entry(gate_);
                one(*answerer_, k);
            }
        }
    }

    /// @throws Cancelled
    void check() const override { check_cancelled(progress_); }

  private:
    /// Counts predicates of the engine's thread for the caller's, who waits, while the object lives.
    class CountForCaller {
      public:
        explicit CountForCaller(PredicateCount& callers)
            : callers_(callers), own_(std::exchange(predicate_count(), callers)) {}
        ~CountForCaller() { callers_ = std::exchange(predicate_count(), own_); }
        CountForCaller(const CountForCaller&) = delete;
        CountForCaller& operator=(const CountForCaller&) = delete;

      private:
        PredicateCount& callers_;
        PredicateCount own_;
    };

    /// Counts what another answers. Each has cache lines of its own, since each counts in its own thread.
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

    Session(const Session& session, Answerer& answerer, EngineGate& gate)
        : engine_(session.engine_),
          model_(session.model_),
          progress_(session.progress_),
          answerer_(&answerer),
          gate_(&gate) {}

    static std::vector<CountingAnswerer> answerers_of(Model& model, int most) {
        std::vector<CountingAnswerer> answerers;
        for (Answerer* more = model.answerer(0); more != nullptr && static_cast<int>(answerers.size()) < most;
             more = model.answerer(static_cast<int>(answerers.size()))) {
            answerers.emplace_back(*more);
        }
        return answerers;
    }

    Engine& engine_;
    std::shared_ptr<Model> model_;
    const Progress* progress_;
    Answerer* answerer_ = nullptr;  // null: the engine's thread answers
    EngineGate* gate_ = nullptr;
};

}  // namespace mq::geometry
