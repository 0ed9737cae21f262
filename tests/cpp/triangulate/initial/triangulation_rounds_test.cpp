// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/triangulation_rounds.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <atomic>
#include <chrono>
#include <thread>

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/analytic/analytic_model.h"
#include "geometry/shapes.h"

namespace mq::triangulate {
namespace {

using namespace geometry;  // the shapes of its tests

// All rounds, and those in which the border may change: more than any test needs.
constexpr RoundLimits kLimits{64, 48};

/// A cube whose faces are not triangulated, but request the halvings that a test chooses.
class FaceRounds : public testing::Test {
  protected:
    explicit FaceRounds(std::shared_ptr<geometry::Model> model = geometry::make_box(1.0, 1.0, 1.0))
        : model_(std::move(model)) {
        result_.faces.resize(faces());
    }

    std::size_t faces() const { return model_->topology().faces.size(); }
    std::vector<int> all() const {
        std::vector<int> open;
        for (int f = 0; f < static_cast<int>(faces()); ++f) {
            open.push_back(f);
        }
        return open;
    }
    /// Returns an edge of the face that is not collapsed.
    int edge_of(int face) const {
        for (const geometry::EdgeUse& use : model_->topology().uses) {
            if (use.face == face && !result_.chains.chain(use.edge).collapsed) {
                return use.edge;
            }
        }
        return -1;
    }
    std::size_t pieces_of(int edge) const { return result_.chains.chain(edge).t.size() - 1; }
    void run(std::vector<int> open, const std::function<bool(int)>& included, const FaceTriangulator& triangulate) {
        triangulate_in_rounds(session_, result_, std::move(open), kLimits, progress_, included, triangulate);
    }
    /// Does one round, in which no face requests anything.
    void run_in_parallel(const std::function<void(geometry::Oracle&, int)>& work) {
        triangulate_in_rounds(
            session_, result_, all(), kLimits, progress_, [](int) { return true; },
            [&](geometry::Oracle& oracle, int f, bool) { work(oracle, f); });
    }

    std::shared_ptr<geometry::Model> model_;
    geometry::Engine engine_{geometry::Engine::Mode::Direct};
    geometry::Session session_{engine_, model_};
    SinglePrecisionGrid grid_{model_->topology().box};
    Progress progress_;
    InitialTriangulation result_{EdgeDiscretisation(session_, grid_), {}, {}};
};

bool any_face(int) {
    return true;
}

TEST_F(FaceRounds, FacesThatWishNothingAreDoneOnce) {
    std::vector<int> calls(faces(), 0);
    run(all(), any_face, [&](int f, bool) { ++calls[f]; });
    EXPECT_EQ(calls, std::vector<int>(faces(), 1));
    EXPECT_TRUE(result_.failures.empty());
}

/// As where two borders lie on each other: all their pieces cross, however short they are.
TEST_F(FaceRounds, AFaceThatWishesForAllPiecesForEverIsGivenUp) {
    const int edge = edge_of(0);
    run({0}, any_face, [&](int f, bool) {
        result_.faces[f].marks.clear();
        for (std::size_t i = 0; f == 0 && i < pieces_of(edge); ++i) {
            result_.faces[f].marks.insert({edge, static_cast<int>(i)});
        }
    });
    EXPECT_LE(pieces_of(edge), 8192u);
    ASSERT_EQ(result_.failures.size(), 1u);
    EXPECT_EQ(result_.failures[0].first, 0);
}

TEST_F(FaceRounds, PiecesThatAreWishedForAreHalvedForAllFacesBesideThem) {
    const int edge = edge_of(0);
    const std::size_t before = pieces_of(edge);
    std::vector<int> calls(faces(), 0);
    run({0}, any_face, [&](int f, bool) {
        result_.faces[f].marks.clear();
        if (f == 0 && calls[f] < 2) {
            result_.faces[f].marks.insert({edge, 0});
        }
        ++calls[f];
    });
    EXPECT_EQ(pieces_of(edge), before + 2);
    EXPECT_EQ(calls[0], 3);
    for (const int u : model_->topology().edges[edge].uses) {
        EXPECT_GE(calls[model_->topology().uses[u].face], 2);
    }
    EXPECT_TRUE(result_.failures.empty());
}

TEST_F(FaceRounds, WishesThatCannotBeGrantedDoNotCount) {
    const int edge = edge_of(0);
    bool wished = true;
    run({0}, any_face, [&](int f, bool border_may_change) {
        result_.faces[f].marks.clear();
        if (f == 0 && border_may_change) {
            result_.faces[f].marks.insert({edge, 0});
        }
        wished = f == 0 ? border_may_change : wished;
    });
    EXPECT_FALSE(wished);  // one more round without the request
    EXPECT_TRUE(result_.failures.empty());
}

TEST_F(FaceRounds, BordersThatStayInTheWayAreFailures) {
    const int edge = edge_of(0);
    run({0}, any_face, [&](int f, bool) {
        if (f == 0) {
            result_.faces[f].marks = {{edge, 0}};
        }
    });
    ASSERT_EQ(result_.failures.size(), 1u);
    EXPECT_EQ(result_.failures[0].first, 0);
    EXPECT_NE(result_.failures[0].second.find("cannot be resolved"), std::string::npos);
}

TEST_F(FaceRounds, FacesThatAreNotIncludedAreLeftAlone) {
    const int edge = edge_of(0);
    int rounds = 0;
    run(
        {0}, [](int f) { return f == 0; },
        [&](int f, bool) {
            EXPECT_EQ(f, 0);
            result_.faces[f].marks.clear();
            if (++rounds < 4) {
                result_.faces[f].marks.insert({edge, 0});
            }
        });
    EXPECT_EQ(rounds, 4);
}

TEST_F(FaceRounds, FacesOfOneRoundAreDoneOnceEachByAnyNumberOfThreads) {
    for (const int threads : {1, 2, 3, 8}) {
        const ThreadLimit limit(threads);
        std::vector<std::atomic<int>> calls(faces());
        run_in_parallel([&](geometry::Oracle& oracle, int f) {
            EXPECT_TRUE(oracle.ask(geometry::Query::face_point(f, 0.5, 0.5)).found());
            ++calls[static_cast<std::size_t>(f)];
        });
        for (const std::atomic<int>& count : calls) {
            EXPECT_EQ(count, 1) << threads << " threads";
        }
    }
}

TEST_F(FaceRounds, NoFaceBeginsOnceItIsCancelled) {
    for (const int threads : {1, 3}) {
        const ThreadLimit limit(threads);
        Progress progress;
        std::atomic<int> begun{0};
        EXPECT_THROW(triangulate_in_rounds(session_, result_, all(), kLimits, progress, any_face,
                                           [&](geometry::Oracle& oracle, int, bool) {
                                               ++begun;
                                               progress.cancel();
                                               oracle.check();
                                               ADD_FAILURE() << "a cancelled face goes on";
                                           }),
                     Cancelled);
        EXPECT_LE(begun, threads);
    }
}

TEST_F(FaceRounds, TheEngineIsOpenToOthersBetweenFaces) {
    using namespace std::chrono_literals;
    const ThreadLimit limit(1);
    geometry::Engine engine;
    geometry::Session session(engine, model_);
    std::atomic<bool> begun{false};
    std::atomic<std::size_t> done{0};
    std::size_t done_before = faces();
    std::thread other([&] {
        while (!begun) {
            std::this_thread::yield();
        }
        engine.ask(model_, geometry::Query::face_point(0, 0.5, 0.5));
        done_before = done;
    });
    triangulate_in_rounds(session, result_, all(), kLimits, progress_, any_face, [&](geometry::Oracle&, int, bool) {
        begun = true;
        std::this_thread::sleep_for(60ms);
        ++done;
    });
    other.join();
    EXPECT_EQ(done, faces());
    EXPECT_LT(done_before, faces());
}

/// A unit cube whose vertices have this tolerance.
std::shared_ptr<geometry::Model> loose_cube(double tolerance) {
    const TopoDS_Shape cube = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
    for (TopExp_Explorer it(cube, TopAbs_VERTEX); it.More(); it.Next()) {
        BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), tolerance);
    }
    return make_shape_model(cube);
}

class LooseFaceRounds : public FaceRounds {
  protected:
    static constexpr double kTolerance = 1e-3;  // mm, large enough to suppress samples.

    LooseFaceRounds() : FaceRounds(loose_cube(kTolerance)) {}

    /// Returns the least distance of the vertices inside the edge from its start, mm.
    double nearest(int edge) const {
        const EdgePolyline& chain = result_.chains.chain(edge);
        const auto point = [&](std::size_t i) { return result_.chains.vertices()[chain.vertices[i]].point; };
        return chain.t.size() > 2 ? (point(1) - point(0)).norm() : 1.0;
    }
};

/// Like a curve on a face with an end artefact longer than the tolerance of its node: the pieces there cross, however
/// short they are.
TEST_F(LooseFaceRounds, HooksBesideNodesAreLeftOutWhereNothingElseHelps) {
    const int edge = edge_of(0);
    bool begun = false;
    const auto crosses_within = [&](double reach) {
        return [&, reach](int f, bool) {
            result_.faces[f].marks.clear();
            if (f == 0 && (!begun || nearest(edge) < reach)) {
                result_.faces[f].marks.insert({edge, 0});
            }
            begun = begun || pieces_of(edge) > 4;
        };
    };
    run({0}, any_face, crosses_within(5.0 * kTolerance));
    EXPECT_TRUE(result_.failures.empty());
    EXPECT_GE(nearest(edge), 8.0 * kTolerance);
    EXPECT_GE(pieces_of(edge), 4u);
    begun = false;
    run({0}, any_face, crosses_within(90.0 * kTolerance));
    EXPECT_EQ(result_.failures.size(), 1u);  // at a distance of at most 32 tolerances
}

}  // namespace
}  // namespace mq::triangulate
