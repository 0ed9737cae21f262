// SPDX-License-Identifier: LGPL-2.1-or-later
#include <benchmark/benchmark.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <cmath>
#include <memory>

#include "geometry/engine.h"
#include "geometry/occt/shape_model.h"

/// What a query costs, answered in the caller's thread and through the engine's, by the size of the batch.
namespace {

using namespace mq::geometry;

std::shared_ptr<Model> cylinder() {
    return make_shape_model(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape());
}

std::shared_ptr<Model> spline() {
    return make_shape_model(
        BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(5.0, 1.0).Shape(), Standard_True).Shape());
}

/// Feet of points just off the first face, from guesses just beside them: what a mesher asks.
Engine::Batch nearest_queries(Model& model, std::size_t count) {
    const Face& face = model.topology().faces.front();
    Engine::Batch batch;
    for (std::size_t i = 0; i < count; ++i) {
        const double a = std::fmod(0.618034 * static_cast<double>(i), 1.0);
        const double b = std::fmod(0.754878 * static_cast<double>(i), 1.0);
        const double u = face.low[0] + a * (face.high[0] - face.low[0]);
        const double v = face.low[1] + (0.05 + 0.9 * b) * (face.high[1] - face.low[1]);
        const Answer here = model.answer(Query::face_point(0, u, v));
        batch.push_back(Query::face_nearest(0, here.point + 0.01 * here.normal, u + 0.02, v - 0.02));
    }
    return batch;
}

void face_nearest(benchmark::State& state, const std::shared_ptr<Model>& model, Engine::Mode mode) {
    Engine engine(mode);
    const auto size = static_cast<std::size_t>(state.range(0));
    const Engine::Batch batch = nearest_queries(*model, size);
    for (auto _ : state) {
        benchmark::DoNotOptimize(engine.ask(model, batch));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// As a mesher that looks ahead: the next batch is handed over before the last one's answers are taken.
void face_nearest_ahead(benchmark::State& state, const std::shared_ptr<Model>& model, Engine::Mode mode) {
    Engine engine(mode);
    const Engine::Batch batch = nearest_queries(*model, static_cast<std::size_t>(state.range(0)));
    auto next = engine.submit(model, batch);
    for (auto _ : state) {
        auto current = std::move(next);
        next = engine.submit(model, batch);
        benchmark::DoNotOptimize(current.get());
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->Arg(1)->Arg(16)->Arg(128)->Arg(1024)->UseRealTime();
}

BENCHMARK_CAPTURE(face_nearest, cylinder_direct, cylinder(), Engine::Mode::Direct)->Apply(sizes);
BENCHMARK_CAPTURE(face_nearest, cylinder_thread, cylinder(), Engine::Mode::Threaded)->Apply(sizes);
BENCHMARK_CAPTURE(face_nearest_ahead, cylinder_thread, cylinder(), Engine::Mode::Threaded)->Apply(sizes);
BENCHMARK_CAPTURE(face_nearest, spline_direct, spline(), Engine::Mode::Direct)->Apply(sizes);
BENCHMARK_CAPTURE(face_nearest, spline_thread, spline(), Engine::Mode::Threaded)->Apply(sizes);
BENCHMARK_CAPTURE(face_nearest_ahead, spline_thread, spline(), Engine::Mode::Threaded)->Apply(sizes);

}  // namespace
