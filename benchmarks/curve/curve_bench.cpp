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
#include "elements/bezier/validity.h"
#include "geometry/occt/shape_model.h"
#include "triangulate/triangulate.h"

/// What the certified test costs an element, and how the deviation of curved surfaces falls with the edge length.
namespace {

using namespace mq;
using namespace mq::curve;
using namespace mq::elements;

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

/// Every triangle cut into four through the middles of its edges on the CAD: the nodes of its curved mesh of order 2.
mesh::TriangleMesh halved(const std::shared_ptr<geometry::Model>& model, const mesh::TriangleMesh& straight) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    const CurvedMesh curved = curve::curve(engine, model, straight, {});
    mesh::TriangleMesh result;
    for (const Vec3& node : curved.nodes) {
        result.vertices.emplace_back(node.cast<float>().cast<double>());
    }
    result.vertex_entity = curved.node_entity;
    for (std::size_t t = 0; t < curved.triangle_face.size(); ++t) {
        const std::int32_t* n = &curved.triangles[6 * t];
        for (const mesh::Triangle& part : {mesh::Triangle{n[0], n[3], n[5]}, mesh::Triangle{n[3], n[1], n[4]},
                                           mesh::Triangle{n[5], n[4], n[2]}, mesh::Triangle{n[3], n[4], n[5]}}) {
            result.triangles.push_back(part);
            result.triangle_face.push_back(curved.triangle_face[t]);
        }
    }
    return result;
}

double rms_deviation(const std::shared_ptr<geometry::Model>& model, const mesh::TriangleMesh& straight, int order) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    curve::CurveOptions options;
    options.order = order;
    return curve::curve(engine, model, straight, options).report.rms_deviation;
}

/// Argument: order. Counters: rms deviation of one mesh and of that halved three times, and the rates between them:
/// with the same triangles in smaller, the rate does not depend on how evenly two meshes happen to be sized.
void deviation(benchmark::State& state, const std::shared_ptr<geometry::Model>& model) {
    const auto order = static_cast<int>(state.range(0));
    for (auto _ : state) {
        geometry::Engine engine(geometry::Engine::Mode::Direct);
        triangulate::TriangulateOptions options;
        options.min_angle = 20.0;
        options.max_edge = 0.5;
        mesh::TriangleMesh straight = triangulate::triangulate(engine, model, options).mesh;
        std::array<double, 4> rms{};
        for (double& value : rms) {
            value = rms_deviation(model, straight, order);
            straight = halved(model, straight);
        }
        state.counters["coarse"] = rms[0];
        state.counters["fine"] = rms[3];
        for (std::size_t i = 1; i < rms.size(); ++i) {
            state.counters["rate_" + std::to_string(i)] = std::log2(rms[i - 1] / rms[i]);
        }
    }
}

std::shared_ptr<geometry::Model> sphere() {
    return geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape());
}

std::shared_ptr<geometry::Model> spline() {
    return geometry::make_shape_model(
        BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(1.0, 0.5).Shape(), Standard_True).Shape());
}

/// Argument: tetrahedra, of order 2 and off their straight places by a twentieth of an edge. To certify a mesh is to
/// form the Jacobian of every element and to bound it.
void certify_mesh(benchmark::State& state) {
    const auto some = elements(2, 0.05);
    const Lattice& lattice = Lattice::of(3, 2);
    const auto count = static_cast<std::size_t>(state.range(0));
    std::vector<std::vector<Vec3>> all(count);
    for (std::size_t i = 0; i < count; ++i) {
        all[i] = some[i % some.size()];
    }
    std::size_t valid = 0;
    for (auto _ : state) {
        valid = 0;
        for (const std::vector<Vec3>& control : all) {
            valid += certified_ratio(jacobian_of(lattice, control)) > 0.0 ? 1 : 0;
        }
        benchmark::DoNotOptimize(valid);
    }
    state.SetComplexityN(state.range(0));
    state.counters["valid"] = static_cast<double>(valid);
}

/// Argument: longest edge on a torus of radii 1 and 0.5, in thousandths. Counters: tetrahedra, and microseconds of the
/// processor for each with everything that curving at order 2 does; the stages are wall time.
void curve_solid(benchmark::State& state) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeTorus(1.0, 0.5).Shape());
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    triangulate::TriangulateOptions options;
    options.min_angle = 20.0;
    options.max_edge = static_cast<double>(state.range(0)) * 1e-3;
    const mesh::TriangleMesh straight = triangulate::triangulate(engine, model, options).mesh;
    curve::CurveOptions curving;
    curving.volume = true;
    for (auto _ : state) {
        const CurveReport report = curve::curve(engine, model, straight, curving).report;
        const auto count = static_cast<double>(report.elements);
        state.counters["tetrahedra"] = count;
        state.counters["invalid"] = static_cast<double>(report.invalid);
        state.counters["us_each"] = 1e6 * report.cpu_seconds / count;
        for (const auto& [stage, seconds] : report.seconds) {
            state.counters[stage] = 1e6 * seconds / count;
        }
    }
}

BENCHMARK(certify)->ArgsProduct({{2, 3, 4}, {0, 50, 100}});
BENCHMARK_CAPTURE(deviation, sphere, sphere())->DenseRange(1, 5)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(deviation, spline, spline())->DenseRange(1, 5)->Unit(benchmark::kMillisecond)->Iterations(1);

BENCHMARK(certify_mesh)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(curve_solid)->Arg(400)->Arg(200)->Arg(100)->Arg(50)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
