// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/components/run_apart.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <array>
#include <atomic>
#include <string>
#include <thread>

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/occt/shape_model.h"

namespace mq::triangulate {
namespace {

class RunApart : public testing::Test {
  protected:
    geometry::Engine engine_;
    geometry::Session session_{engine_, geometry::make_shape_model(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape())};
    Progress whole_;
};

TEST_F(RunApart, CallsAllWithAProgressOfTheirOwn) {
    for (const int threads : {1, 3}) {
        const ThreadLimit limit(threads);
        std::array<const Progress*, 5> seen{};
        run_apart(session_, whole_, 5, [&](geometry::Session& own, const Progress& progress, int k) {
            EXPECT_TRUE(own.ask(geometry::Query::edge_point(0, 0.5)).found());
            seen[static_cast<std::size_t>(k)] = &progress;
        });
        for (std::size_t k = 0; k < seen.size(); ++k) {
            ASSERT_NE(seen[k], nullptr);
            EXPECT_EQ(std::count(seen.begin(), seen.end(), seen[k]), 1);
        }
    }
    run_apart(session_, whole_, 0, [](geometry::Session&, const Progress&, int) { FAIL(); });
}

/// The second one fails first, while the first one, which is not cancelled, and later ones run. With one thread there
/// are no later ones.
TEST_F(RunApart, TheFailureOfTheFirstIsThrown) {
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        std::atomic<bool> failed{false};
        std::string error;
        try {
            run_apart(session_, whole_, 4, [&](geometry::Session&, const Progress& progress, int k) {
                if (k == 1) {
                    failed = true;
                    throw InvalidInput(Message::value("the second"));
                }
                while (threads > 1 && !failed) {
                    std::this_thread::yield();
                }
                while (k > 1) {
                    progress.check();  // ends by the failure
                    std::this_thread::yield();
                }
                EXPECT_FALSE(progress.cancelled());
            });
        } catch (const InvalidInput& thrown) {
            error = thrown.what();
        }
        EXPECT_EQ(error, "the second") << threads;
        EXPECT_FALSE(whole_.cancelled());
    }
}

TEST_F(RunApart, EndsWithTheWhole) {
    EXPECT_THROW(run_apart(session_, whole_, 3,
                           [&](geometry::Session&, const Progress& progress, int) {
                               whole_.cancel();
                               progress.check();
                           }),
                 Cancelled);
}

}  // namespace
}  // namespace mq::triangulate
