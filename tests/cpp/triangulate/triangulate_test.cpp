// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/triangulate.h"

#include <atomic>
#include <chrono>
#include <cstring>
#include <map>
#include <string>
#include <thread>

#include "base/error.h"
#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

using geometry::Engine;
using geometry::Part;

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same(const Result& a, const Result& b) {
    EXPECT_EQ(a.mesh.origin, b.mesh.origin);
    EXPECT_TRUE(same_bytes(a.mesh.vertices, b.mesh.vertices));
    EXPECT_TRUE(same_bytes(a.mesh.triangles, b.mesh.triangles));
    EXPECT_TRUE(same_bytes(a.mesh.triangle_face, b.mesh.triangle_face));
    EXPECT_TRUE(same_bytes(a.mesh.vertex_entity, b.mesh.vertex_entity));
    EXPECT_EQ(a.report.exempt, b.report.exempt);
}

TEST(Triangulate, GivesTheSameBytesOnEveryRunAndEngine) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        TriangulateOptions options;
        options.chord_height_relative = 0.01;
        const Result first = mesh_of(part.model, options, Engine::Mode::Direct);
        expect_same(first, mesh_of(part.model, options, Engine::Mode::Direct));
        expect_same(first, mesh_of(part.model, options, Engine::Mode::Threaded));
    }
}

TEST(Triangulate, GivesTheSameBytesWithAnyNumberOfThreads) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        TriangulateOptions options;
        options.chord_height_relative = 0.001;
        options.threads = 1;
        const Result one = mesh_of(part.model, options, Engine::Mode::Threaded);
        for (const int threads : {2, 3, 8}) {
            options.threads = threads;
            const Result several = mesh_of(part.model, options, Engine::Mode::Threaded);
            expect_same(one, several);
            EXPECT_EQ(one.report.max_chord_height, several.report.max_chord_height);
            EXPECT_EQ(one.report.queries, several.report.queries);
            EXPECT_EQ(one.report.predicates, several.report.predicates);
            EXPECT_EQ(one.report.exact_predicates, several.report.exact_predicates);
        }
    }
}

TEST(Triangulate, ReportsWhatTheMeshIs) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        const Result result = mesh_of(part.model);
        const mesh::MeshReport measured = mesh::measure(result.mesh);
        EXPECT_EQ(result.report.triangles, result.mesh.triangles.size());
        EXPECT_EQ(result.report.vertices, result.mesh.vertices.size());
        EXPECT_EQ(result.report.min_angle, measured.min_angle);
        EXPECT_EQ(result.report.closed, part.closed);
        EXPECT_EQ(result.report.euler, part.euler);
        EXPECT_GT(result.report.queries, 0u);
        EXPECT_GT(result.report.predicates, 0u);
        EXPECT_GE(result.report.max_chord_height, 0.0);
        const std::vector<std::string>& faults = part.model->topology().faults;
        EXPECT_TRUE(std::equal(faults.begin(), faults.end(), result.report.notes.begin(), result.report.notes.end(),
                               [](const std::string& fault, const Message& note) { return note.text() == fault; }));
        EXPECT_FALSE(result.report.seconds.empty());
    }
}

/// Every vertex lies on its entity.
TEST(Triangulate, VerticesLieOnTheirEntities) {
    for (const Part& part : geometry::shape_parts()) {
        SCOPED_TRACE(part.name);
        const Result result = mesh_of(part.model);
        const geometry::Topology& topology = part.model->topology();
        const double slack = SinglePrecisionGrid(topology.box).resolution() + 1e-6;
        for (std::size_t v = 0; v < result.mesh.vertices.size(); ++v) {
            const Vec3 p = result.mesh.vertices[v] + result.mesh.origin;
            const auto [dimension, index] = result.mesh.vertex_entity[v];
            double distance = 1e300;
            if (dimension == 0) {
                distance = (topology.nodes[index].point - p).norm();
            } else if (dimension == 1) {
                const geometry::Edge& edge = topology.edges[index];
                const double middle = 0.5 * (edge.t0 + edge.t1);
                distance =
                    part.model->answer(geometry::Query::edge_nearest(index, p, middle, edge.t0, edge.t1)).distance;
            } else {
                distance = part.model->answer(geometry::Query::face_nearest_global(index, p)).distance;
            }
            EXPECT_LE(distance, slack) << dimension << ", " << index;
        }
    }
}

TEST(Triangulate, StopsAtTheBudgetWithAConsistentMesh) {
    std::map<std::string, std::size_t> coarsest;  // by part: triangles of a mesh that nothing was added to
    for (const std::size_t budget : {1u, 50u, 200u, 2000u}) {
        for (const Part& part : geometry::analytic_parts()) {
            SCOPED_TRACE(part.name + " " + std::to_string(budget));
            TriangulateOptions options;
            options.chord_height_relative = 1e-4;
            options.max_triangles = budget;
            const Result result = mesh_of(part.model, options);
            expect_sound(result, part.euler, part.closed);
            expect_angles(result, options.min_angle);
            const std::size_t least = coarsest.emplace(part.name, result.mesh.triangles.size()).first->second;
            EXPECT_LE(result.mesh.triangles.size(), std::max(budget, least));
            if (part.name == "analytic box" && budget >= 50) {
                EXPECT_TRUE(result.report.complete);
                continue;
            }
            EXPECT_FALSE(result.report.complete);
            ASSERT_FALSE(result.report.notes.empty());
            EXPECT_NE(result.report.notes.back().text().find("max_triangles"), std::string::npos);
            EXPECT_EQ(result.report.notes.back().text().rfind("the coarsest mesh", 0) == 0, least > budget);
        }
    }
}

// All edges of a round are halved together: the limit holds within the round, too.
TEST(Triangulate, NeverExceedsTheBudget) {
    for (const std::size_t budget : {1000u, 3000u, 10001u}) {
        for (const double max_edge : {1e-3, 1e-4}) {
            SCOPED_TRACE(std::to_string(budget) + " " + std::to_string(max_edge));
            TriangulateOptions options;
            options.max_edge = max_edge;
            options.max_triangles = budget;
            const Result result = mesh_of(geometry::make_box(1.0, 1.0, 1.0), options);
            expect_sound(result, 2, true);
            EXPECT_FALSE(result.report.complete);
            EXPECT_LE(result.mesh.triangles.size(), budget);
            EXPECT_GT(result.mesh.triangles.size() + 10, budget);
        }
    }
}

// A mesh that needs all triangles that it may have is complete.
TEST(Triangulate, IsCompleteWithAsManyTrianglesAsItMayHave) {
    TriangulateOptions options;
    options.max_triangles = 12;
    const Result result = mesh_of(geometry::make_box(1.0, 1.0, 1.0), options);
    EXPECT_TRUE(result.report.complete);
    EXPECT_EQ(result.mesh.triangles.size(), 12u);
}

// Fans of a hundred thousand triangles around the poles: no step after the limit may visit the whole fan for each of
// its triangles, which once took more than fifteen minutes.
TEST(Triangulate, EndsAtTheBudgetWithLongFans) {
    TriangulateOptions options;
    options.max_edge = 2.0 * M_PI / 1e5;
    options.max_triangles = 100000;
    const Result result = mesh_of(geometry::make_sphere(1.0), options);
    EXPECT_FALSE(result.report.complete);
    EXPECT_LT(result.report.self_intersections, 0);  // no search took place
    EXPECT_LE(result.mesh.triangles.size(), options.max_triangles);
    EXPECT_GT(result.report.exempt.size(), 90000u);
    EXPECT_GE(result.report.min_angle_unexempted, options.min_angle);
    for (const auto& [triangle, why] : result.report.exempt) {
        ASSERT_EQ(why.cause, mesh::ExemptCause::Budget) << triangle << ": " << mesh::message_of(why).text();
    }
}

TEST(Triangulate, IsCancelledFromAnotherThread) {
    const auto model = geometry::make_torus(5.0, 1.5);
    TriangulateOptions options;
    options.chord_height = 1e-5;
    for (const Engine::Mode mode : {Engine::Mode::Threaded, Engine::Mode::Direct}) {
        Engine engine(mode);
        Progress progress;
        std::atomic<bool> ended{false};
        std::thread watcher([&] {
            while (progress.fraction() < 0.4 && !ended) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            progress.cancel();
        });
        EXPECT_THROW(triangulate(engine, model, options, &progress), Cancelled);
        ended = true;
        watcher.join();
        const Result after = triangulate(engine, geometry::make_box(1.0, 2.0, 3.0));
        expect_sound(after, 2, true);
    }
}

TEST(Triangulate, CancelledBeforeItStartsItDoesNothing) {
    Engine engine;
    Progress progress;
    progress.cancel();
    EXPECT_THROW(triangulate(engine, geometry::make_sphere(1.0), {}, &progress), Cancelled);
}

TEST(Triangulate, EndsItsProgressAtOne) {
    Engine engine;
    Progress progress;
    triangulate(engine, geometry::make_sphere(1.0), {}, &progress);
    EXPECT_GE(progress.fraction(), 0.9);
    EXPECT_LE(progress.fraction(), 1.0);
}

TEST(Triangulate, AStoppedEngineIsAnErrorNotACrash) {
    Engine engine;
    engine.shut_down();
    EXPECT_THROW(triangulate(engine, geometry::make_sphere(1.0)), Error);
}

TEST(Triangulate, KeepsItsAnglesFarFromTheOrigin) {
    for (const TopoDS_Shape& shape : {BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape(), geometry::stored("filleted_box"),
                                      BRepPrimAPI_MakeTorus(5.0, 1.5).Shape()}) {
        const auto near = mesh::measure(mesh_of(geometry::make_shape_model(shape)).mesh);
        const Result result = mesh_of(geometry::make_shape_model(geometry::moved_to(shape, 1e6, -1e6, 1e6)));
        EXPECT_GT(result.mesh.origin.norm(), 1e6);
        expect_sound(result, near.euler, true);
        expect_angles(result, 25.0);
        EXPECT_TRUE(result.report.exempt.empty());
        EXPECT_NEAR(result.report.volume, near.volume, 0.1 * near.volume);
    }
}

TEST(Triangulate, WorksAtEverySize) {
    for (const double scale : {1e-3, 1e3, 1e6}) {
        SCOPED_TRACE(scale);
        const std::vector<Part> parts{{"sphere", geometry::make_sphere(2.0 * scale), 2, true},
                                      {"cylinder", geometry::make_cylinder(2.0 * scale, 5.0 * scale), 2, true},
                                      {"torus", geometry::make_torus(5.0 * scale, 1.5 * scale), 0, true},
                                      {"box", geometry::make_box(1.0 * scale, 2.0 * scale, 3.0 * scale), 2, true}};
        for (const Part& part : parts) {
            SCOPED_TRACE(part.name);
            TriangulateOptions options;
            options.chord_height_relative = 0.005;
            const Result result = mesh_of(part.model, options);
            expect_sound(result, part.euler, true);
            expect_angles(result, options.min_angle);
            EXPECT_TRUE(result.report.exempt.empty());
            EXPECT_LE(result.report.max_chord_height, 0.006 * part.model->topology().box.largest_side());
        }
    }
}

/// OpenCASCADE's own tolerance is 1e-7 mm: such shapes are as small, or as large, as possible.
TEST(Triangulate, WorksOnTinyAndHugeShapes) {
    for (const double scale : {1e-3, 1e5}) {
        SCOPED_TRACE(scale);
        for (const char* name : {"fused", "bored"}) {
            SCOPED_TRACE(name);
            const Result result = mesh_of(geometry::make_shape_model(geometry::scaled(geometry::stored(name), scale)));
            expect_sound(result, std::string(name) == "bored" ? 0 : 2, true);
            expect_angles(result, 25.0);
        }
    }
}

/// Several threads may mesh at once on one engine. Two CAD edges of the shape end at the same nodes, and both chords
/// are within the tolerance of their curves at first.
TEST(Triangulate, EdgesBetweenTheSameNodesStayTwoEdges) {
    const auto model = geometry::make_shape_model(geometry::stored("doubled_edge"));
    for (const double bound : {0.0, 0.02, 0.004464248404181683}) {
        SCOPED_TRACE(bound);
        TriangulateOptions options;
        options.min_angle = 20.265115815158513;
        options.chord_height_relative = bound;
        const Result result = mesh_of(model, options);
        expect_sound(result, 2, true);
        expect_angles(result, options.min_angle);
    }
}

TEST(Triangulate, SharesAnEngineBetweenThreads) {
    Engine engine;
    const auto model = geometry::make_torus(5.0, 1.5);
    const Result expected = mesh_of(model);
    std::vector<Result> results(3);
    std::vector<std::thread> threads;
    for (Result& result : results) {
        threads.emplace_back([&engine, &model, &result] { result = triangulate(engine, model); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const Result& result : results) {
        expect_same(expected, result);
    }
}

}  // namespace
}  // namespace mq::triangulate
