// SPDX-License-Identifier: LGPL-2.1-or-later
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include "elements/product/check_elements.h"
#include "elements/product/reference_nodes.h"

/// What the check of given elements costs by kind and order, on one thread.
namespace {

using namespace mq;
using namespace mq::elements;

/// Elements whose nodes are off their straight places by up to 0.1 / order along each axis.
std::vector<std::vector<Vec3>> elements(ElementKind kind, int order, int count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-0.1 / order, 0.1 / order);
    std::vector<std::vector<Vec3>> all;
    for (int i = 0; i < count; ++i) {
        all.push_back(reference_nodes(kind, order));
        for (Vec3& node : all.back()) {
            node += Vec3(uniform(random), uniform(random), dimension_of(kind) == 2 ? 0.0 : uniform(random));
        }
    }
    return all;
}

/// Arguments: kind, order. The time is that of one element.
void check(benchmark::State& state) {
    const auto kind = static_cast<ElementKind>(state.range(0));
    const auto order = static_cast<int>(state.range(1));
    const std::vector<std::vector<Vec3>> all = elements(kind, order, 100);
    const ElementJacobian jacobian(kind, order, full_node_count(kind, order));
    std::size_t next = 0;
    std::size_t valid = 0;
    std::size_t done = 0;
    for (auto _ : state) {
        valid += judge(jacobian.of(all[next])).verdict == Verdict::Valid ? 1 : 0;
        next = (next + 1) % all.size();
        ++done;
    }
    state.SetLabel(name_of(kind));
    state.counters["valid"] = static_cast<double>(valid) / static_cast<double>(done);
}

BENCHMARK(check)->ArgsProduct({{0, 1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}})->Unit(benchmark::kMicrosecond);

}  // namespace
