// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/engine.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "base/error.h"
#include "base/waits.h"
#include "geometry/analytic/analytic_model.h"
#include "geometry/elementary/surface.h"

namespace mq::geometry {
namespace {

using namespace std::chrono_literals;

/// Echoes the query's t; can be blocked, and records the thread on which it was called.
class EchoModel final : public Model {
  public:
    Answer answer(const Query& query) noexcept override {
        thread = std::this_thread::get_id();
        started = true;
        while (held) {
            std::this_thread::yield();
        }
        Answer answer;
        answer.status = Status::Ok;
        answer.t = query.t;
        return answer;
    }
    std::optional<ElementarySurface> elementary_surface(int /*face*/) override { return std::nullopt; }
    void add_definition(Entity /*entity*/, int /*frame*/, Fingerprint& /*key*/) override {}
    void add_definition_of_use(int /*use*/, Fingerprint& /*key*/) override {}

    std::atomic<bool> held{false};
    std::atomic<bool> started{false};
    std::atomic<std::thread::id> thread{};
};

Engine::Batch numbered(int count, double from = 0.0) {
    Engine::Batch batch;
    for (int i = 0; i < count; ++i) {
        batch.push_back(Query::edge_point(0, from + i));
    }
    return batch;
}

void wait_until(const std::atomic<bool>& flag) {
    while (!flag) {
        std::this_thread::yield();
    }
}

/// The name of what the operation waits for, once it has one.
std::string wait_of(const Waits& waits) {
    for (int i = 0; i < 500; ++i) {
        if (const std::string what = waits.lasting(0ms).text(); !what.empty()) {
            return what;
        }
        std::this_thread::sleep_for(10ms);
    }
    return std::string();
}

TEST(Engine, NamesWhatACallerWaitsFor) {
    Engine engine;
    const auto model = std::make_shared<EchoModel>();
    model->held = true;
    Progress first;
    Progress second;
    first.stage("refining angles", 0.0, 1.0);
    const Waits first_waits(first, "Mesh of Bracket");
    const Waits second_waits(second, "Mesh of Box");
    std::thread user([&] { engine.ask(model, numbered(1), &first); });
    wait_until(model->started);
    std::thread waiter([&] { engine.ask(model, numbered(1), &second); });
    EXPECT_EQ(wait_of(first_waits), "waits for OpenCASCADE: refining angles");
    EXPECT_EQ(wait_of(second_waits), "waits for the shape engine, used by Mesh of Bracket");
    EXPECT_EQ(second_waits.lasting(1h).text(), "");
    model->held = false;
    user.join();
    waiter.join();
    EXPECT_EQ(first_waits.lasting(0ms).text(), "");
    EXPECT_EQ(second_waits.lasting(0ms).text(), "");
}

TEST(Engine, AnswersInOrderOnItsOwnThread) {
    Engine engine;
    const auto model = std::make_shared<EchoModel>();
    const Engine::Answers answers = engine.ask(model, numbered(100));
    ASSERT_EQ(answers.size(), 100u);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(answers[static_cast<std::size_t>(i)].status, Status::Ok);
        EXPECT_EQ(answers[static_cast<std::size_t>(i)].t, i);
    }
    EXPECT_NE(model->thread.load(), std::this_thread::get_id());
    EXPECT_EQ(engine.queries(), 100u);
    EXPECT_EQ(engine.ask(model, Query::edge_point(0, 7.0)).t, 7.0);
    EXPECT_EQ(engine.queries(), 101u);
}

TEST(Engine, DirectModeAnswersInTheCallersThread) {
    Engine engine(Engine::Mode::Direct);
    const auto model = std::make_shared<EchoModel>();
    EXPECT_EQ(engine.ask(model, numbered(3)).back().t, 2.0);
    EXPECT_EQ(model->thread.load(), std::this_thread::get_id());
    bool ran = false;
    engine.run([&] { ran = true; });
    EXPECT_TRUE(ran);
    engine.shut_down();
    EXPECT_EQ(engine.ask(model, numbered(1)).front().status, Status::Stopped);
}

TEST(Engine, ServesEmptyBatchesAndRefusesNoModel) {
    Engine engine;
    EXPECT_TRUE(engine.ask(std::make_shared<EchoModel>(), Engine::Batch{}).empty());
    EXPECT_EQ(engine.ask(nullptr, numbered(2)).back().status, Status::BadQuery);
}

TEST(Engine, ServesSeveralThreadsAndModels) {
    Engine engine(Engine::Mode::Threaded, 2);
    const std::shared_ptr<Model> models[2] = {make_sphere(1.0), make_sphere(2.0)};
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (int n = 0; n < 4; ++n) {
        threads.emplace_back([&, n] {
            for (int i = 0; i < 50; ++i) {
                const double u = 0.01 * i;
                const Engine::Answers answers =
                    engine.ask(models[n % 2], Engine::Batch(20, Query::face_point(0, u, 0.3)));
                for (const Answer& answer : answers) {
                    wrong += std::abs(answer.point.norm() - (1.0 + n % 2)) > 1e-12 ? 1 : 0;
                }
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(engine.queries(), 4u * 50u * 20u);
}

TEST(Engine, SubmitWaitsWhileTheQueueIsFull) {
    Engine engine(Engine::Mode::Threaded, 2);
    const auto model = std::make_shared<EchoModel>();
    model->held = true;
    std::vector<std::future<Engine::Answers>> futures;
    futures.push_back(engine.submit(model, numbered(1)));
    wait_until(model->started);
    futures.push_back(engine.submit(model, numbered(1)));
    futures.push_back(engine.submit(model, numbered(1)));
    std::atomic<bool> through{false};
    std::future<Engine::Answers> last;
    std::thread asker([&] {
        last = engine.submit(model, numbered(1, 5.0));
        through = true;
    });
    std::this_thread::sleep_for(20ms);
    EXPECT_FALSE(through);
    model->held = false;
    asker.join();
    EXPECT_EQ(last.get().front().t, 5.0);
    for (auto& future : futures) {
        EXPECT_EQ(future.get().front().status, Status::Ok);
    }
}

TEST(Engine, WithdrawsWhatACancelledCallerWaitsFor) {
    Engine engine(Engine::Mode::Threaded, 2);
    const auto model = std::make_shared<EchoModel>();
    model->held = true;
    std::future<Engine::Answers> running = engine.submit(model, numbered(1));
    wait_until(model->started);
    Progress progress;
    std::atomic<int> cancelled{0};
    bool ran = false;
    const auto count_cancelled = [&](const auto& call) {
        try {
            call();
        } catch (const Cancelled&) {
            ++cancelled;
        }
    };
    // Two batches wait in the queue, and one for room in it.
    std::thread asker([&] { count_cancelled([&] { engine.ask(model, numbered(1), &progress); }); });
    std::thread runner([&] { count_cancelled([&] { engine.run([&] { ran = true; }, &progress); }); });
    std::thread waiter([&] { count_cancelled([&] { engine.ask(model, numbered(1), &progress); }); });
    std::this_thread::sleep_for(40ms);
    EXPECT_EQ(cancelled, 0);
    const auto start = std::chrono::steady_clock::now();
    progress.cancel();
    asker.join();
    runner.join();
    waiter.join();
    EXPECT_LT(std::chrono::steady_clock::now() - start, 200ms);
    EXPECT_EQ(cancelled, 3);
    model->held = false;
    EXPECT_EQ(running.get().front().status, Status::Ok);
    EXPECT_EQ(engine.ask(model, Query::edge_point(0, 7.0)).t, 7.0);
    EXPECT_FALSE(ran);
    EXPECT_EQ(engine.queries(), 2u);
}

TEST(Engine, CancelDropsWhatWaitsAndCutsTheRunningBatchShort) {
    Engine engine;
    const auto model = std::make_shared<EchoModel>();
    model->held = true;
    auto running = engine.submit(model, numbered(10));
    wait_until(model->started);
    auto waiting = engine.submit(model, numbered(10));
    engine.cancel();
    for (const Answer& answer : waiting.get()) {
        EXPECT_EQ(answer.status, Status::Stopped);
    }
    model->held = false;
    const Engine::Answers answers = running.get();
    EXPECT_EQ(answers.front().status, Status::Ok);
    for (std::size_t i = 1; i < answers.size(); ++i) {
        EXPECT_EQ(answers[i].status, Status::Stopped);
    }
    EXPECT_EQ(engine.queries(), 1u);
    // The engine continues to answer.
    EXPECT_EQ(engine.ask(model, numbered(1)).front().status, Status::Ok);
}

TEST(Engine, CancelKeepsWorkToBeRun) {
    Engine engine;
    const auto model = std::make_shared<EchoModel>();
    model->held = true;
    auto running = engine.submit(model, numbered(1));
    wait_until(model->started);
    bool ran = false;
    std::thread runner([&] { engine.run([&] { ran = true; }); });
    std::this_thread::sleep_for(5ms);
    engine.cancel();
    model->held = false;
    runner.join();
    EXPECT_TRUE(ran);
    running.get();
}

TEST(Engine, ShutDownStopsEverythingAndIsIdempotent) {
    Engine engine;
    const auto model = std::make_shared<EchoModel>();
    model->held = true;
    auto running = engine.submit(model, numbered(5));
    wait_until(model->started);
    auto waiting = engine.submit(model, numbered(5));
    std::thread closer([&] { engine.shut_down(); });
    EXPECT_EQ(waiting.get().front().status, Status::Stopped);
    model->held = false;
    engine.shut_down();
    closer.join();
    EXPECT_EQ(running.get().back().status, Status::Stopped);
    EXPECT_EQ(engine.ask(model, numbered(3)).back().status, Status::Stopped);
    EXPECT_THROW(engine.run([] {}), Cancelled);
}

TEST(Engine, ShutDownFreesWaitingAskers) {
    Engine engine(Engine::Mode::Threaded, 1);
    const auto model = std::make_shared<EchoModel>();
    model->held = true;
    auto running = engine.submit(model, numbered(1));
    wait_until(model->started);
    std::vector<std::thread> askers;
    std::atomic<int> stopped{0};
    for (int i = 0; i < 3; ++i) {
        askers.emplace_back(
            [&] { stopped += engine.ask(model, numbered(1)).front().status == Status::Stopped ? 1 : 0; });
    }
    std::this_thread::sleep_for(10ms);
    std::thread closer([&] { engine.shut_down(); });
    for (std::thread& asker : askers) {
        asker.join();
    }
    EXPECT_EQ(stopped, 3);
    model->held = false;
    closer.join();
    EXPECT_EQ(running.get().size(), 1u);
}

TEST(Engine, RunDeliversExceptionsToTheCaller) {
    Engine engine;
    EXPECT_THROW(engine.run([] { throw InvalidInput(Message::value("no shape")); }), InvalidInput);
    EXPECT_THROW(engine.run([] { throw 7; }), int);
    std::thread::id thread;
    engine.run([&] { thread = std::this_thread::get_id(); });
    EXPECT_NE(thread, std::this_thread::get_id());
}

TEST(Engine, WorkMayAskTheEngineItself) {
    Engine engine;
    const auto model = std::make_shared<EchoModel>();
    Answer answer;
    engine.run([&] { engine.run([&] { answer = engine.ask(model, Query::edge_point(0, 3.0)); }); });
    EXPECT_EQ(answer.t, 3.0);
}

TEST(Engine, ShutDownFromItsOwnThread) {
    Engine engine;
    engine.run([&] { engine.shut_down(); });
    EXPECT_EQ(engine.ask(std::make_shared<EchoModel>(), numbered(1)).front().status, Status::Stopped);
}

TEST(Engine, DestructionAnswersWaitingBatches) {
    const auto model = std::make_shared<EchoModel>();
    model->held = true;
    std::vector<std::future<Engine::Answers>> futures;
    std::thread opener;
    {
        Engine engine;
        futures.push_back(engine.submit(model, numbered(4)));
        wait_until(model->started);
        for (int i = 0; i < 5; ++i) {
            futures.push_back(engine.submit(model, numbered(4)));
        }
        opener = std::thread([&] {
            std::this_thread::sleep_for(5ms);
            model->held = false;
        });
    }
    opener.join();
    for (auto& future : futures) {
        EXPECT_EQ(future.get().back().status, Status::Stopped);
    }
}

TEST(Engine, LetsGoOfTheModelBeforeTheAnswersArrive) {
    Engine engine;
    auto model = std::make_shared<EchoModel>();
    for (int i = 0; i < 200; ++i) {
        engine.ask(model, numbered(1));
        ASSERT_EQ(model.use_count(), 1);
    }
}

/// Askers, a canceller and the end at once: every answer is either right or Stopped.
TEST(Engine, SurvivesCancelAndShutDownInMidFlight) {
    for (int round = 0; round < 20; ++round) {
        Engine engine(Engine::Mode::Threaded, 3);
        const auto model = std::make_shared<EchoModel>();
        std::atomic<int> wrong{0};
        std::vector<std::thread> threads;
        for (int n = 0; n < 3; ++n) {
            threads.emplace_back([&] {
                for (int i = 0; i < 40; ++i) {
                    const Engine::Answers answers = engine.ask(model, numbered(30));
                    for (std::size_t k = 0; k < answers.size(); ++k) {
                        const bool right = answers[k].status == Status::Ok && answers[k].t == static_cast<double>(k);
                        wrong += right || answers[k].status == Status::Stopped ? 0 : 1;
                    }
                }
            });
        }
        threads.emplace_back([&] {
            for (int i = 0; i < 10; ++i) {
                engine.cancel();
                std::this_thread::yield();
            }
        });
        std::this_thread::sleep_for(std::chrono::microseconds(200 * round));
        engine.shut_down();
        for (std::thread& thread : threads) {
            thread.join();
        }
        EXPECT_EQ(wrong, 0);
    }
}

}  // namespace
}  // namespace mq::geometry
