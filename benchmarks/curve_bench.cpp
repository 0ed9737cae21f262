// SPDX-License-Identifier: LGPL-2.1-or-later
#include <benchmark/benchmark.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "curve/curve.h"
#include "curve/validity.h"
#include "geometry/occt/shape_model.h"
#include "triangulate/triangulate.h"

/// What the certified test costs an element, and how the deviation of curved surfaces falls with the edge length.
namespace {

using namespace mq;
using namespace mq::curve;

/// Tetrahedra whose nodes are off their straight places by up to `size` of an edge.
std::vector<std::vector<Vec3>> elements(int order, double size) {
    const Lattice& lattice = Lattice::of(3, order);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-size, size);
    std::vector<std::vector<Vec3>> all(1000);
    for (std::vector<Vec3>& control : all) {
        for (int i = 0; i < lattice.size(); ++i) {
            const Barycentric b = lattice.node(i);
            control.emplace_back(b[1] + uniform(random), b[2] + uniform(random), b[3] + uniform(random));
        }
        control = nodes_to_bezier(lattice, control);
    }
    return all;
}

/// Arguments: order, offset of the nodes in thousandths of an edge.
void certify(benchmark::State& state) {
    const auto order = static_cast<int>(state.range(0));
    const auto all = elements(order, static_cast<double>(state.range(1)) * 1e-3);
    const Lattice& lattice = Lattice::of(3, order);
    std::size_t valid = 0;
    for (auto _ : state) {
        valid = 0;
        for (const std::vector<Vec3>& control : all) {
            valid += check_positive(jacobian_of(lattice, control)).valid ? 1 : 0;
        }
        benchmark::DoNotOptimize(valid);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size()));
    state.counters["valid"] = static_cast<double>(valid) / static_cast<double>(all.size());
}

CurvedMesh curved(const std::shared_ptr<geometry::Model>& model, int order, double edge) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    triangulate::Options straight;
    straight.min_angle = 20.0;
    straight.max_edge = edge;
    curve::Options options;
    options.order = order;
    return curve::curve(engine, model, triangulate::triangulate(engine, model, straight).mesh, options);
}

/// Argument: order. Counters: rms deviation by radius at edges of 0.5 and 0.25, and the rate between them.
void deviation(benchmark::State& state, const std::shared_ptr<geometry::Model>& model) {
    const auto order = static_cast<int>(state.range(0));
    for (auto _ : state) {
        const CurveReport coarse = curved(model, order, 0.4).report;
        const CurveReport fine = curved(model, order, 0.2).report;
        const double h = std::sqrt(static_cast<double>(fine.elements) / static_cast<double>(coarse.elements));
        state.counters["coarse"] = coarse.rms_deviation;
        state.counters["fine"] = fine.rms_deviation;
        state.counters["rate"] = std::log(coarse.rms_deviation / fine.rms_deviation) / std::log(h);
    }
}

std::shared_ptr<geometry::Model> sphere() {
    return geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape());
}

std::shared_ptr<geometry::Model> spline() {
    return geometry::make_shape_model(
        BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(1.0, 0.5).Shape(), Standard_True).Shape());
}

BENCHMARK(certify)->ArgsProduct({{2, 3, 4}, {0, 50, 100}});
BENCHMARK_CAPTURE(deviation, sphere, sphere())->DenseRange(1, 5)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(deviation, spline, spline())->DenseRange(1, 5)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
