// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/predicates.h"
#include "geometry/elementary/surface.h"

namespace mq::geometry {
namespace {

using namespace std::chrono_literals;

/// Doubles the query's t, on the threads that it records.
class DoublingAnswerer final : public Answerer {
  public:
    Answer answer(const Query& query) noexcept override {
        ++inside_;
        alone = alone && inside_ == 1;
        thread = std::this_thread::get_id();
        Answer answer;
        answer.status = Status::Ok;
        answer.t = 2.0 * query.t;
        --inside_;
        return answer;
    }

    std::atomic<std::thread::id> thread{};
    std::atomic<bool> alone{true};  ///< whether no two threads asked at a time

  private:
    std::atomic<int> inside_{0};
};

class DoublingModel final : public Model {
  public:
    Answer answer(const Query& query) noexcept override { return first.answer(query); }
    Answerer* answerer(int thread) override {
        if (thread == 0) {
            return this;
        }
        if (static_cast<int>(further.size()) < thread) {
            further.push_back(std::make_unique<DoublingAnswerer>());
        }
        return further[static_cast<std::size_t>(thread) - 1].get();
    }
    std::optional<ElementarySurface> elementary_surface(int /*face*/) override { return std::nullopt; }
    void add_definition(Entity /*entity*/, int /*frame*/, Fingerprint& /*key*/) override {}
    void add_definition_of_use(int /*use*/, Fingerprint& /*key*/) override {}

    DoublingAnswerer first;
    std::vector<std::unique_ptr<DoublingAnswerer>> further;
};

Engine::Batch numbered(std::size_t count) {
    Engine::Batch batch;
    for (std::size_t i = 0; i < count; ++i) {
        batch.push_back(Query::edge_point(0, static_cast<double>(i)));
    }
    return batch;
}

TEST(Session, AnswersInTheBatchsOrderWithAnyNumberOfThreads) {
    for (const int threads : {1, 2, 3, 8}) {
        const ThreadLimit limit(threads);
        for (const std::size_t count : {std::size_t{1}, Session::kChunk, Session::kChunk + 1, std::size_t{100'000}}) {
            Engine engine;
            const auto model = std::make_shared<DoublingModel>();
            Session session(engine, model);
            const Engine::Answers answers = session.ask(numbered(count));
            ASSERT_EQ(answers.size(), count);
            for (std::size_t i = 0; i < count; ++i) {
                ASSERT_EQ(answers[i].status, Status::Ok);
                ASSERT_EQ(answers[i].t, 2.0 * static_cast<double>(i));
            }
            EXPECT_EQ(engine.queries(), count);
            EXPECT_TRUE(model->first.alone);
            for (const auto& answerer : model->further) {
                EXPECT_TRUE(answerer->alone);
            }
            EXPECT_LT(static_cast<int>(model->further.size()), threads);
        }
    }
}

TEST(Session, AnswersSmallBatchesOnTheEnginesThread) {
    const ThreadLimit limit(8);
    Engine engine;
    const auto model = std::make_shared<DoublingModel>();
    Session session(engine, model);
    std::thread::id engines_own;
    engine.run([&] { engines_own = std::this_thread::get_id(); });
    EXPECT_EQ(session.ask(numbered(Session::kChunk)).back().t, 2.0 * (Session::kChunk - 1));
    EXPECT_TRUE(model->further.empty());
    EXPECT_EQ(model->first.thread.load(), engines_own);
    EXPECT_TRUE(session.ask(Engine::Batch()).empty());
}

/// Two chunks that wait for each other end only where two threads work at a time.
TEST(Session, WorksOnChunksAtATime) {
    const ThreadLimit limit(2);
    Engine engine;
    Session session(engine, std::make_shared<DoublingModel>());
    std::atomic<int> arrived{0};
    std::atomic<bool> met{true};
    session.for_chunks(2 * Session::kChunk, [&](Answerer& /*answerer*/, std::size_t /*from*/, std::size_t /*to*/) {
        ++arrived;
        const auto end = std::chrono::steady_clock::now() + 20s;
        while (arrived < 2 && std::chrono::steady_clock::now() < end) {
            std::this_thread::yield();
        }
        met = met && arrived == 2;
    });
    EXPECT_TRUE(met);
}

TEST(Session, GivesEveryItemToOneChunk) {
    for (const int threads : {1, 3}) {
        const ThreadLimit limit(threads);
        Engine engine;
        Session session(engine, std::make_shared<DoublingModel>());
        std::vector<int> seen(50'001, 0);
        session.for_chunks(seen.size(), [&](Answerer& /*answerer*/, std::size_t from, std::size_t to) {
            EXPECT_LE(to - from, Session::kChunk);
            for (std::size_t i = from; i < to; ++i) {
                ++seen[i];
            }
        });
        EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
        session.for_chunks(0, [](Answerer&, std::size_t, std::size_t) { FAIL() << "there is nothing to do"; });
    }
}

TEST(Session, EndsSoonOnceCancelledAndTheEngineGoesOn) {
    const ThreadLimit limit(3);
    Engine engine;
    Progress progress;
    Session session(engine, std::make_shared<DoublingModel>(), &progress);
    std::atomic<int> chunks{0};
    EXPECT_THROW(session.for_chunks(1'000'000,
                                    [&](Answerer& /*answerer*/, std::size_t /*from*/, std::size_t /*to*/) {
                                        if (++chunks == 5) {
                                            progress.cancel();
                                        }
                                    }),
                 Cancelled);
    EXPECT_LE(chunks, 5 + 2);  // the other threads may have begun one each
    EXPECT_THROW(session.ask(numbered(10'000)), Cancelled);
    Session other(engine, std::make_shared<DoublingModel>());
    EXPECT_EQ(other.ask(numbered(10'000)).back().t, 2.0 * 9'999);
}

bool is_engines(const Engine& engine) {
    try {
        engine.check_own_thread();
    } catch (const std::logic_error&) {
        return false;
    }
    return true;
}

/// What asks in place is answered by its own thread, one batch as well as many chunks.
TEST(Session, AnswersInPlaceInTheThreadsThatAsk) {
    for (const int threads : {1, 3}) {
        const ThreadLimit limit(threads);
        Engine engine;
        const auto model = std::make_shared<DoublingModel>();
        Session session(engine, model);
        session.in_place([&](Session& own) {
            EXPECT_EQ(own.ask(numbered(4)).back().t, 6.0);
            EXPECT_EQ(model->first.thread.load(), std::this_thread::get_id());
            EXPECT_EQ(own.ask(numbered(3).back()).t, 4.0);
            EXPECT_EQ(own.ask(numbered(100'000)).back().t, 2.0 * 99'999);
            own.run([&](Model& of_session) {
                EXPECT_EQ(&of_session, model.get());
                EXPECT_EQ(thread_count(), threads);
            });
            EXPECT_EQ(own.queries(), 100'005U);
        });
        EXPECT_EQ(engine.queries(), 100'005U);
        EXPECT_TRUE(model->first.alone);
        EXPECT_LT(static_cast<int>(model->further.size()), threads);
        for (const auto& answerer : model->further) {
            EXPECT_TRUE(answerer->alone);
        }
        EXPECT_EQ(session.ask(numbered(3)).back().t, 4.0);
    }
}

/// Whoever calls only waits: for what is done in place, for calls apart, and for large batches.
TEST(Session, WorksOnThreadsOfTheEngineOnly) {
    const ThreadLimit limit(3);
    const std::thread::id caller = std::this_thread::get_id();
    for (const Engine::Mode mode : {Engine::Mode::Threaded, Engine::Mode::Direct}) {
        Engine engine(mode);
        Session session(engine, std::make_shared<DoublingModel>());
        const bool threaded = mode == Engine::Mode::Threaded;
        EXPECT_EQ(is_engines(engine), !threaded);
        std::atomic<int> calls{0};
        const auto check = [&](bool in_job) {
            ++calls;
            EXPECT_TRUE(is_engines(engine));
            EXPECT_TRUE(!(threaded || in_job) || std::this_thread::get_id() != caller);
        };
        session.for_chunks(50'000, [&](Answerer&, std::size_t, std::size_t) { check(false); });
        session.run([&](Model&) { check(false); });
        session.in_place([&](Session& own) {
            check(true);
            own.for_chunks(50'000, [&](Answerer&, std::size_t, std::size_t) { check(true); });
            own.run([&](Model&) { check(true); });
            own.run_apart(8, [&](Session& /*apart*/, int /*k*/) {
                check(true);
                parallel_for(4, [&](int /*i*/) { check(true); });
            });
        });
        session.run_apart(8, [&](Session& /*apart*/, int /*k*/) { check(true); });
        EXPECT_EQ(calls, 2 * 196 + 1 + 1 + 1 + 8 * 5 + 8);
    }
}

/// A thread that the engine does not own is refused, wherever it got its session from.
TEST(Session, IsNotAskedOnOtherThreads) {
    Engine engine;
    Session session(engine, std::make_shared<DoublingModel>());
    int refused = 0;
    session.in_place([&](Session& own) {
        std::thread other([&] {
            for (const std::size_t count : {1, 10'000}) {
                EXPECT_THROW(own.ask(numbered(count)), std::logic_error);
                ++refused;
            }
            EXPECT_THROW(own.ask(numbered(1).front()), std::logic_error);
            EXPECT_THROW(own.run([](Model&) {}), std::logic_error);
            EXPECT_THROW(own.run_apart(2, [](Session& apart, int) { apart.ask(numbered(1)); }), std::logic_error);
        });
        other.join();
        EXPECT_EQ(own.ask(numbered(3)).back().t, 4.0);
    });
    EXPECT_EQ(refused, 2);
}

TEST(Session, CountsPredicatesForWhoeverCalls) {
    const ThreadLimit limit(3);
    Engine engine;
    Session session(engine, std::make_shared<DoublingModel>());
    const auto decide = [] { orient2d(Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0)); };
    predicate_count() = {};
    decide();
    const std::uint64_t one = predicate_count().filtered;
    ASSERT_EQ(one, 1U);
    session.in_place([&](Session& own) {
        EXPECT_EQ(thread_count(), 3);
        decide();
        own.run_apart(5, [&](Session& /*apart*/, int /*k*/) { decide(); });
    });
    EXPECT_EQ(predicate_count().filtered, 7 * one);
    session.run([&](Model&) { decide(); });
    EXPECT_EQ(predicate_count().filtered, 8 * one);
    predicate_count() = {};
    session.in_place([&](Session& /*own*/) {});
    EXPECT_EQ(predicate_count().filtered, 0U);  // the thread's counts of before are not its next caller's
}

/// Two jobs that wait for each other's questions end only where both run at a time; their threads are kept.
TEST(Session, JobsRunSideBySideOnThreadsThatAreKept) {
    Engine engine;
    const auto job = [&](std::atomic<int>& asked, const std::atomic<int>& others, std::thread::id& thread) {
        Session(engine, std::make_shared<DoublingModel>()).in_place([&](Session& own) {
            thread = std::this_thread::get_id();
            for (int n = 0; n < 10; ++n) {
                EXPECT_EQ(own.ask(numbered(3)).back().t, 4.0);
                ++asked;
                const auto end = std::chrono::steady_clock::now() + 20s;
                while (others < n && std::chrono::steady_clock::now() < end) {
                    std::this_thread::yield();
                }
                EXPECT_GE(others, n);
            }
        });
    };
    std::set<std::thread::id> threads;
    for (int round = 0; round < 3; ++round) {
        std::atomic<int> first{0};
        std::atomic<int> second{0};
        std::thread::id of_first;
        std::thread::id of_second;
        std::thread other([&] { job(second, first, of_second); });
        job(first, second, of_first);
        other.join();
        EXPECT_NE(of_first, of_second);
        threads.insert({of_first, of_second});
    }
    EXPECT_EQ(threads.size(), 2U);
}

/// The time after which a test that waits for other threads has failed.
std::chrono::steady_clock::time_point deadline() {
    return std::chrono::steady_clock::now() + 20s;
}

/// Others wait until the gate closes, not for all that is done in place, even when nothing is asked there.
TEST(Session, IsOpenToOthersBetweenAnswersInPlace) {
    for (const bool asks : {true, false}) {
        Engine engine;
        const auto model = std::make_shared<DoublingModel>();
        std::atomic<int> answered{0};
        std::atomic<bool> started{false};
        std::thread other([&] {
            for (const auto end = deadline(); !started && std::chrono::steady_clock::now() < end;) {
                std::this_thread::yield();
            }
            for (int n = 0; n < 5; ++n) {
                Session(engine, model).ask(numbered(1));
                ++answered;
            }
        });
        EXPECT_NO_THROW(Session(engine, model).in_place([&](Session& own) {
            own.ask(numbered(1));
            started = true;
            for (const auto end = deadline(); answered < 5 && std::chrono::steady_clock::now() < end;) {
                if (asks) {
                    own.ask(numbered(1));
                }
            }
            EXPECT_EQ(answered, 5);
        }));
        other.join();
        EXPECT_TRUE(model->first.alone);  // never asked in place and by the engine's thread at a time
    }
}

/// What is done in place ends while another job has the engine, if it needs no more answers.
TEST(Session, EndsInPlaceBeforeALongJobOfOthers) {
    Engine engine;
    std::atomic<bool> release{false};
    std::atomic<bool> began{false};
    std::thread other;
    EXPECT_NO_THROW(Session(engine, std::make_shared<DoublingModel>()).in_place([&](Session& own) {
        own.ask(numbered(3));
        other = std::thread([&] {
            engine.run([&] {
                began = true;
                for (const auto end = deadline(); !release && std::chrono::steady_clock::now() < end;) {
                    std::this_thread::yield();
                }
                EXPECT_TRUE(release);
            });
        });
        for (const auto end = deadline(); !began && std::chrono::steady_clock::now() < end;) {
            std::this_thread::yield();
        }
    }));
    release = true;
    other.join();
}

TEST(Session, IsNotInPlaceOnTheEnginesThreadNorWithoutAnAnswerer) {
    class Silent final : public Model {
      public:
        Answer answer(const Query& /*query*/) noexcept override { return {}; }
        Answerer* answerer(int /*thread*/) override { return nullptr; }
        std::optional<ElementarySurface> elementary_surface(int /*face*/) override { return std::nullopt; }
        void add_definition(Entity /*entity*/, int /*frame*/, Fingerprint& /*key*/) override {}
        void add_definition_of_use(int /*use*/, Fingerprint& /*key*/) override {}
    };
    Engine engine;
    const auto nothing = [](Session& own) { own.ask(numbered(1)); };
    EXPECT_THROW(Session(engine, std::make_shared<Silent>()).in_place(nothing), std::logic_error);
    EXPECT_THROW(engine.run([&] { Session(engine, std::make_shared<DoublingModel>()).in_place(nothing); }),
                 std::logic_error);
}

/// What would wait for itself is refused, and says so; the engine goes on.
TEST(Session, RefusesWhatAJobWouldWaitFor) {
    Engine engine;
    const auto model = std::make_shared<DoublingModel>();
    const auto said = [](const auto& call) {
        try {
            call();
        } catch (const std::logic_error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    Session session(engine, model);
    session.in_place([&](Session& own) {
        const std::string waits = "a job of the geometry engine would wait for itself: it must ask its own session";
        EXPECT_EQ(said([&] { session.in_place([](Session&) {}); }), waits);
        EXPECT_EQ(said([&] { own.in_place([](Session&) {}); }),
                  "a job of the geometry engine cannot begin another one, for which it would wait");
        EXPECT_EQ(said([&] { session.ask(numbered(1)); }), waits);
        EXPECT_EQ(said([&] { engine.run([] {}); }), waits);
        own.for_chunks(10, [&](Answerer&, std::size_t, std::size_t) {
            EXPECT_EQ(said([&] { engine.ask(model, numbered(1)); }), waits);
        });
        EXPECT_EQ(own.ask(numbered(3)).back().t, 4.0);
    });
    EXPECT_EQ(session.ask(numbered(3)).back().t, 4.0);
}

TEST(Session, PassesOnWhatIsThrownInPlace) {
    Engine engine;
    Progress progress;
    Session session(engine, std::make_shared<DoublingModel>(), &progress);
    EXPECT_THROW(session.in_place([](Session& /*own*/) { throw std::runtime_error("here"); }), std::runtime_error);
    EXPECT_EQ(session.ask(numbered(3)).back().t, 4.0);
    EXPECT_THROW(session.in_place([&](Session& own) {
        own.ask(numbered(3));
        progress.cancel();
        own.ask(numbered(3));
    }),
                 Cancelled);
}

/// Whoever waits for other work of the engine is told to end at once.
TEST(Session, WaitsInPlaceNoLongerThanUntilItIsCancelled) {
    Engine engine;
    const auto model = std::make_shared<DoublingModel>();
    Progress progress;
    std::atomic<bool> release{false};
    std::thread other;
    EXPECT_THROW(Session(engine, model, &progress).in_place([&](Session& own) {
        own.ask(numbered(3));
        other = std::thread([&] {
            engine.run([&] {
                progress.cancel();
                for (const auto end = deadline(); !release && std::chrono::steady_clock::now() < end;) {
                    std::this_thread::yield();
                }
                EXPECT_TRUE(release);
            });
        });
        for (const auto end = deadline(); std::chrono::steady_clock::now() < end;) {
            own.ask(numbered(3).back());  // does not look at the progress: the gate ends it
        }
    }),
                 Cancelled);
    release = true;
    other.join();
}

TEST(Session, IsShutDownWhileItAnswersInPlace) {
    Engine engine;
    EXPECT_THROW(Session(engine, std::make_shared<DoublingModel>()).in_place([&](Session& own) {
        own.ask(numbered(3));
        engine.shut_down();
        for (const auto end = deadline(); std::chrono::steady_clock::now() < end;) {
            own.ask(numbered(3));
        }
    }),
                 Cancelled);
}

TEST(Session, ThrowsWhatAChunkThrew) {
    const ThreadLimit limit(2);
    Engine engine;
    Session session(engine, std::make_shared<DoublingModel>());
    EXPECT_THROW(session.for_chunks(10 * Session::kChunk,
                                    [](Answerer& /*answerer*/, std::size_t from, std::size_t /*to*/) {
                                        if (from == 3 * Session::kChunk) {
                                            throw std::runtime_error("here");
                                        }
                                    }),
                 std::runtime_error);
    EXPECT_EQ(session.ask(numbered(3)).back().t, 4.0);
}

TEST(Session, CallsApartAreAnsweredInTheirThreads) {
    for (const int threads : {1, 2, 3, 8}) {
        const ThreadLimit limit(threads);
        Engine engine;
        Session session(engine, std::make_shared<DoublingModel>());
        std::vector<double> sums(20, 0.0);
        session.run_apart(static_cast<int>(sums.size()), [&](Session& own, int k) {
            double& sum = sums[static_cast<std::size_t>(k)];
            for (const Answer& answer : own.ask(numbered(100))) {
                sum += answer.t;
            }
            own.for_chunks(1000, [&](Answerer& answerer, std::size_t from, std::size_t to) {
                for (const Query& query : numbered(static_cast<int>(to - from))) {
                    sum += answerer.answer(query).t;
                }
            });
            sum += own.ask(numbered(2).back()).t;
        });
        for (const double sum : sums) {
            EXPECT_EQ(sum, 99.0 * 100.0 + 3.0 * 255.0 * 256.0 + 231.0 * 232.0 + 2.0);
        }
        EXPECT_EQ(engine.queries(), sums.size() * 1101);
    }
}

TEST(Session, TheEngineIsOpenToOthersWhileCallsAreApart) {
    const ThreadLimit limit(2);
    Engine engine;
    auto model = std::make_shared<DoublingModel>();
    Session session(engine, model);
    std::atomic<bool> answered{false};
    std::thread other([&] {
        EXPECT_EQ(engine.ask(model, numbered(3)).back().t, 4.0);
        answered = true;
    });
    session.run_apart(2, [&](Session& own, int /*k*/) {
        while (!answered) {
            EXPECT_EQ(own.ask(numbered(3)).back().t, 4.0);
        }
    });
    other.join();
    EXPECT_TRUE(model->first.alone);  // never asked by a call and by the engine's thread at a time
}

TEST(Session, CallsApartDoNotReachTheModel) {
    Engine engine;
    Session session(engine, std::make_shared<DoublingModel>());
    EXPECT_THROW(session.run_apart(2, [](Session& own, int /*k*/) { own.run([](Model& /*model*/) {}); }),
                 std::logic_error);
}

TEST(Session, ThrowsWhatTheFirstCallApartThrew) {
    const ThreadLimit limit(3);
    Engine engine;
    Progress progress;
    Session session(engine, std::make_shared<DoublingModel>(), &progress);
    EXPECT_THROW(session.run_apart(8,
                                   [](Session& own, int k) {
                                       own.ask(numbered(10));
                                       if (k == 0) {
                                           throw std::runtime_error("first");
                                       }
                                   }),
                 std::runtime_error);
    EXPECT_EQ(session.ask(numbered(3)).back().t, 4.0);
    EXPECT_THROW(session.run_apart(2,
                                   [&](Session& own, int /*k*/) {
                                       progress.cancel();
                                       own.ask(numbered(10));
                                   }),
                 Cancelled);
}

}  // namespace
}  // namespace mq::geometry
