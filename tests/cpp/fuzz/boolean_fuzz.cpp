// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Booleans of random pairs of solids, with random placements and defects, and every promise checked on each result.
//
//     fuzz_boolean FIRST LAST [turned | dirty]
//
// runs the seeds FIRST to LAST - 1 with all four operations and prints what failed. `turned` turns both operands
// together at random, so that faces that were flush are so only to within rounding. `dirty` has cracks, sheets beside
// solids, two-sided surfaces and triangles at random ways round. The status is 1 if anything failed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "base/error.h"
#include "boolean/boolean.h"
#include "boolean/random_meshes.h"
#include "mesh/quality/surface_verification.h"

namespace mq::boolean {
namespace {

constexpr Operation kOperations[] = {Operation::Union, Operation::Intersection, Operation::Difference,
                                     Operation::SymmetricDifference};

/// Every triangle said to be an operand's own has its corners.
bool sources_hold(const BooleanResult& result, const fuzz::Pair& pair) {
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        const auto [operand, index] = result.triangle_source[t];
        if (operand < 0) {
            continue;
        }
        const mesh::TriangleMesh& own = operand == 0 ? pair.a : pair.b;
        const mesh::Triangle& c = own.triangles[static_cast<std::size_t>(index)];
        for (const std::int32_t v : result.mesh.triangles[t]) {
            if (std::none_of(c.begin(), c.end(), [&](std::int32_t w) {
                    return own.vertices[static_cast<std::size_t>(w)] ==
                           result.mesh.vertices[static_cast<std::size_t>(v)];
                })) {
                return false;
            }
        }
    }
    return true;
}

double volume(const mesh::TriangleMesh& mesh) {
    return mesh::verify(mesh.vertices, mesh.triangles).volume;
}

/// What the Booleans of a pair measure.
struct Figures {
    double volume[4] = {0.0, 0.0, 0.0, 0.0};
    double error_bound = 0.0;  ///< the largest
};

/// What is wrong with a result; empty when nothing is.
std::string fault_of(const fuzz::Pair& pair, Operation operation, Figures& figures) {
    const BooleanResult result = boolean({&pair.a, &pair.b}, operation, {});
    const mesh::Verification check = mesh::verify(result.mesh.vertices, result.mesh.triangles);
    figures.volume[static_cast<int>(operation)] = check.volume;
    figures.error_bound = std::max(figures.error_bound, result.error_bound);
    if (!check.passed()) {
        return check.summary();
    }
    return sources_hold(result, pair) ? std::string() : "a retained triangle is not the operand's";
}

/// Of the operands and their Booleans: volumes add up to within what moving all surfaces by the bound may take.
std::string fault_of_volumes(const fuzz::Pair& pair, const Figures& figures) {
    constexpr double kPart = 1e-5;
    const double(&v)[4] = figures.volume;
    const double a = volume(pair.whole.empty() ? pair.a : pair.whole[0]);
    const double b = volume(pair.whole.empty() ? pair.b : pair.whole[1]);
    const double worst = std::max(std::abs(v[0] + v[1] - a - b), std::abs(v[2] - (a - v[1])));
    const double most = kPart * (a + b) + figures.error_bound * (fuzz::area(pair.a) + fuzz::area(pair.b));
    return worst <= most ? std::string() : "volumes are wrong by " + std::to_string(worst);
}

struct Totals {
    int results = 0;
    int failed = 0;
    int refused = 0;
};

void report(Totals& totals, const fuzz::Pair& pair, const char* what, const std::string& fault) {
    ++totals.failed;
    std::printf("%s | %s: %s\n", pair.description.c_str(), what, fault.c_str());
}

void run(const fuzz::Pair& pair, Totals& totals) {
    Figures figures;
    bool all = true;
    for (const Operation operation : kOperations) {
        std::string fault;
        try {
            ++totals.results;
            fault = fault_of(pair, operation, figures);
        } catch (const InvalidInput& error) {
            all = false;
            if (!pair.clean) {
                ++totals.refused;
                continue;
            }
            fault = error.what();
        } catch (const Error& error) {
            fault = error.what();
        }
        if (!fault.empty()) {
            all = false;
            report(totals, pair, name(operation), fault);
        }
    }
    if (all && pair.clean) {
        const std::string fault = fault_of_volumes(pair, figures);
        if (!fault.empty()) {
            report(totals, pair, "volumes", fault);
        }
    }
}

int main(int count, char** arguments) {
    if (count < 3) {
        std::fprintf(stderr, "usage: fuzz_boolean FIRST LAST [turned | dirty]\n");
        return 2;
    }
    const std::string kind = count > 3 ? arguments[3] : "";
    const auto make = kind == "turned" ? fuzz::turned_pair : kind == "dirty" ? fuzz::dirty_pair : fuzz::random_pair;
    const long first = std::atol(arguments[1]);
    const long last = std::atol(arguments[2]);
    Totals totals;
    const std::clock_t start = std::clock();
    for (long seed = first; seed < last; ++seed) {
        const auto number = static_cast<std::uint64_t>(seed);
        run(make(number), totals);
        std::fflush(stdout);
    }
    std::printf("%ld pairs, %d results, %d failed, %d refused, %.1f s of processor\n", last - first, totals.results,
                totals.failed, totals.refused, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    return totals.failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace mq::boolean

int main(int count, char** arguments) {
    return mq::boolean::main(count, arguments);
}
