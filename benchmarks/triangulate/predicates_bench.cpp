// SPDX-License-Identifier: LGPL-2.1-or-later
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/predicates.h"

namespace mq {
namespace {

constexpr int kPoints = 4096;

enum Kind { kRandom, kLattice, kTurnedSquares };

/// Groups of four neighbours: two triangles and their common edge, as the triangulator meets them. On the lattice and
/// on turned squares many comparisons are ties, or nearly.
std::vector<Vec3> quadrilaterals(int kind) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    std::uniform_int_distribution<int> integer(-20, 20);
    std::vector<Vec3> points;
    while (points.size() < kPoints) {
        const Vec3 base = kind == kLattice ? Vec3(Vec3(integer(random), integer(random), integer(random)) * 0.25)
                                           : Vec3(100.0 * real(random), 100.0 * real(random), 100.0 * real(random));
        Vec3 x(0.25, 0, 0);
        Vec3 y(0, 0.25, 0);
        if (kind != kLattice) {
            x = Vec3(real(random), real(random), real(random));
            const Vec3 other(real(random), real(random), real(random));
            y = kind == kTurnedSquares ? Vec3(x.cross(other).normalized() * x.norm()) : other;
        }
        for (const Vec3& corner : {base, Vec3(base + x + y), Vec3(base + y), Vec3(base + x)}) {
            points.push_back(to_single(corner));
        }
    }
    return points;
}

/// Runs `predicate` on the four corners of one group after the other.
template <typename Predicate>
void run(benchmark::State& state, Predicate predicate) {
    const std::vector<Vec3> v = quadrilaterals(static_cast<int>(state.range(0)));
    const PredicateCount before = predicate_count();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(predicate(v[i], v[i + 1], v[i + 2], v[i + 3]));
        i = (i + 4) % kPoints;
    }
    const auto exact = static_cast<double>(predicate_count().exact - before.exact);
    const auto filtered = static_cast<double>(predicate_count().filtered - before.filtered);
    state.counters["exact_share"] = exact + filtered > 0.0 ? exact / (exact + filtered) : 0.0;
}

double angle(const Vec3& a, const Vec3& o, const Vec3& b) {
    const double cosine = (a - o).dot(b - o) / ((a - o).norm() * (b - o).norm());
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::min({angle(c, a, b), angle(a, b, c), angle(b, c, a)});
}

bool naive_maxmin(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    return std::min(smallest_angle(p, q, r), smallest_angle(q, p, s)) >=
           std::min(smallest_angle(r, s, q), smallest_angle(s, r, p));
}

void locally_maxmin_bench(benchmark::State& state) {
    run(state, locally_maxmin);
}

/// The baseline: the definition in floating point, wrong for near-ties.
void naive_maxmin_bench(benchmark::State& state) {
    run(state, naive_maxmin);
}

void sign_dot_bench(benchmark::State& state) {
    run(state, [](const Vec3& p, const Vec3&, const Vec3& r, const Vec3& s) { return sign_dot(p, r, s); });
}

void in_circle_bench(benchmark::State& state) {
    run(state, [](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
        return in_circle(p.head<2>(), s.head<2>(), q.head<2>(), r.head<2>());
    });
}

void kinds(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("kind")->Arg(kRandom)->Arg(kLattice)->Arg(kTurnedSquares);
}

BENCHMARK(locally_maxmin_bench)->Apply(kinds);
BENCHMARK(naive_maxmin_bench)->Apply(kinds);
BENCHMARK(sign_dot_bench)->Apply(kinds);
BENCHMARK(in_circle_bench)->Apply(kinds);

}  // namespace
}  // namespace mq
