// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What surrounds the exact part of a Boolean, on a torus of about a million triangles: the tree, the search for
// contacts, the preparation of an operand and the verification of a result. Items are triangles.
#include <benchmark/benchmark.h>

#include <cmath>

#include "boolean/input/operand_repair.h"
#include "mesh/corner_table.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/quality/surface_verification.h"
#include "mesh/weld_vertices.h"

namespace mq {
namespace {

const mesh::TriangleMesh& torus() {
    static const mesh::TriangleMesh mesh = [] {
        constexpr int kAround = 1024;
        constexpr int kAcross = 512;
        mesh::TriangleMesh torus;
        const auto at = [](int i, int j) { return (i % kAround) * kAcross + j % kAcross; };
        for (int i = 0; i < kAround; ++i) {
            for (int j = 0; j < kAcross; ++j) {
                const double u = 2 * M_PI * i / kAround;
                const double v = 2 * M_PI * j / kAcross;
                const Vec3 point((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
                torus.vertices.emplace_back(to_single(point));
                torus.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                torus.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
        return torus;
    }();
    return mesh;
}

/// One triangle in twenty, as if these had been made anew: a band across the torus.
std::vector<std::int32_t> changed_band() {
    std::vector<std::int32_t> band;
    for (std::size_t t = 0; t < torus().triangles.size() / 20; ++t) {
        band.push_back(static_cast<std::int32_t>(t));
    }
    return band;
}

void count_triangles(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(torus().triangles.size()));
}

void build_tree(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(mesh::AabbTree(torus().vertices, torus().triangles).size());
    }
    count_triangles(state);
}
BENCHMARK(build_tree)->Unit(benchmark::kMillisecond);

void own_pairs(benchmark::State& state) {
    const mesh::AabbTree tree(torus().vertices, torus().triangles);
    std::size_t pairs = 0;
    for (auto _ : state) {
        tree.for_each_own_pair([&pairs](std::int32_t, std::int32_t) { ++pairs; });
    }
    benchmark::DoNotOptimize(pairs);
    count_triangles(state);
}
BENCHMARK(own_pairs)->Unit(benchmark::kMillisecond);

void weld_and_twins(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(mesh::equal_vertices(torus().vertices).data());
        benchmark::DoNotOptimize(mesh::edge_twins(torus().triangles, torus().vertices.size()).data());
    }
    count_triangles(state);
}
BENCHMARK(weld_and_twins)->Unit(benchmark::kMillisecond);

void self_intersections(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(mesh::self_intersections(torus().vertices, torus().triangles).size());
    }
    count_triangles(state);
}
BENCHMARK(self_intersections)->Unit(benchmark::kMillisecond);

void prepare_operand(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(boolean::prepare_operand(torus(), "operand A").triangles.data());
    }
    count_triangles(state);
}
BENCHMARK(prepare_operand)->Unit(benchmark::kMillisecond);

void prepare_operand_with_holes(benchmark::State& state) {
    mesh::TriangleMesh mesh = torus();
    for (int i = 0; i < 20; ++i) {
        mesh.triangles.erase(mesh.triangles.begin() + 50000 * i);
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(boolean::prepare_operand(mesh, "operand A").triangles.data());
    }
    count_triangles(state);
}
BENCHMARK(prepare_operand_with_holes)->Unit(benchmark::kMillisecond);

void verify_all(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(mesh::verify(torus().vertices, torus().triangles).passed());
    }
    count_triangles(state);
}
BENCHMARK(verify_all)->Unit(benchmark::kMillisecond);

void verify_changed(benchmark::State& state) {
    const std::vector<std::int32_t> changed = changed_band();
    for (auto _ : state) {
        benchmark::DoNotOptimize(mesh::verify(torus().vertices, torus().triangles, &changed).passed());
    }
    count_triangles(state);
}
BENCHMARK(verify_changed)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mq
