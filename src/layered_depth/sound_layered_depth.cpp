// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/sound_layered_depth.h"

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

#include "base/stopwatch.h"
#include "boolean/boolean.h"
#include "boolean/error_measure.h"
#include "mesh/quality/surface_verification.h"

namespace mq::layered_depth {

using boolean::Expression;

namespace {

/// Mean distance by which vertices of faulty triangles are moved inward, as a fraction of the tolerance; less where
/// vertices were put on CAD faces, so that they stay near these.
constexpr double kShift = 0.02;
constexpr double kShiftOnFaces = 0.005;

/// Moves the vertices of faulty triangles inward, each by a random length, except those of operands' own triangles. The
/// scheme makes sheets that coincide but for rounding. The move turns a film between two of them inside out; if they
/// still cross, it is at angles at which the intersections can be rounded.
void shift_faulty(UniformResult& result, const std::vector<mesh::Fault>& faults, double length) {
    std::vector<Vec3>& vertices = result.mesh.vertices;
    std::vector<char> own(vertices.size(), 0);
    std::vector<char> faulty(vertices.size(), 0);
    std::vector<Vec3> normal(vertices.size(), Vec3::Zero());
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        const auto [a, b, c] = result.mesh.triangles[t];
        const Vec3 area = (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]);
        for (const std::int32_t v : {a, b, c}) {
            normal[v] += area;
            own[v] |= static_cast<char>(result.triangle_source[t][0] >= 0 ? 1 : 0);
        }
    }
    for (const mesh::Fault& fault : faults) {
        for (const std::int32_t t : fault.triangles) {
            if (t >= 0) {
                for (const std::int32_t v : result.mesh.triangles[static_cast<std::size_t>(t)]) {
                    faulty[v] = 1;
                }
            }
        }
    }
    std::mt19937 random(1);  // the same on every machine
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (faulty[v] != 0 && own[v] == 0) {
            const double share = 0.5 + random() / 4294967296.0;
            vertices[v] = to_single(vertices[v] - share * length * normal[v].normalized());
        }
    }
}

/// The error of a result, measured both ways, and how far the operands were moved by their repair, mm.
/// @param thinnest  the thickness below which films and gaps do not count, mm
double measured_error(const std::vector<UniformOperand>& prepared, const Expression& expression,
                      const UniformResult& result, double tolerance, double thinnest, const Progress& progress) {
    // Distances below this fraction of the tolerance are not refined, to save time.
    constexpr double kEnough = 0.05;
    std::vector<std::vector<char>> given(prepared.size());  // triangles of operands that the result has
    std::vector<char> own;
    for (const auto& [operand, triangle] : result.triangle_source) {
        own.push_back(operand >= 0 ? 1 : 0);
        if (operand >= 0) {
            std::vector<char>& kept = given[static_cast<std::size_t>(operand)];
            kept.resize(std::max(kept.size(), static_cast<std::size_t>(triangle) + 1), 0);
            kept[static_cast<std::size_t>(triangle)] = 1;
        }
    }
    std::vector<boolean::EnclosedOperand> enclosed;
    double moved = 0.0;
    for (std::size_t k = 0; k < prepared.size(); ++k) {
        const UniformOperand& operand = prepared[k];
        enclosed.push_back(
            {&operand.mesh().vertices, &operand.mesh().triangles, operand.open() ? &operand.winding() : nullptr, {}});
        for (std::size_t t = 0; t < operand.mesh().triangles.size(); ++t) {
            const auto source = static_cast<std::size_t>(operand.source(static_cast<std::int32_t>(t)));
            enclosed.back().retained.push_back(source < given[k].size() ? given[k][source] : 0);
        }
        moved = std::max(moved, operand.largest_move());
    }
    return boolean::measure_error(enclosed, expression, result.mesh, own, {tolerance, kEnough * tolerance, thinnest},
                                  progress)
               .largest() +
           moved;
}

}  // namespace

void remove_crossings(UniformResult& result, double tolerance, Progress& progress) {
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    const mesh::Verification check =
        mesh::verify(result.mesh.vertices, result.mesh.triangles, nullptr, kAll, &progress);
    if (check.passed()) {
        return;
    }
    shift_faulty(result, check.faults, (result.fitted > 0 ? kShiftOnFaces : kShift) * tolerance);
    boolean::BooleanOptions options;
    options.tolerance = tolerance;
    options.oriented = true;
    boolean::BooleanResult sound =
        boolean::boolean({&result.mesh}, Expression::chain(boolean::Operation::Union, 1), options, &progress);
    std::vector<std::array<std::int32_t, 2>> source;
    source.reserve(sound.triangle_source.size());
    result.retained = 0;
    for (const auto& [operand, triangle] : sound.triangle_source) {
        source.push_back(operand < 0 ? std::array<std::int32_t, 2>{-1, -1}
                                     : result.triangle_source[static_cast<std::size_t>(triangle)]);
        result.retained += source.back()[0] >= 0 ? 1 : 0;
    }
    result.crossing_pairs = check.count[static_cast<std::size_t>(mesh::FaultKind::Crossing)];
    result.mesh = std::move(sound.mesh);
    result.triangle_source = std::move(source);
    result.seconds.insert(result.seconds.end(), sound.seconds.begin(), sound.seconds.end());
}

UniformResult sound_layered_depth_boolean(const std::vector<const mesh::TriangleMesh*>& operands,
                                          const Expression& expression, const LayeredDepthOptions& options,
                                          double tolerance, Progress& progress, const CadOperands& cad) {
    const std::vector<UniformOperand> prepared = prepare_uniform(operands, expression, options, &progress);
    UniformResult result = layered_depth_boolean(prepared, expression, options, &progress, cad);
    remove_crossings(result, tolerance, progress);
    const Stopwatch measuring;
    progress.stage("measuring", 1.0, 1.0);
    const double thinnest = options.thinnest * options.resolution * result.spacing;
    result.error_bound = measured_error(prepared, expression, result, tolerance, thinnest, progress);
    result.seconds.emplace_back("measuring", measuring.wall());
    return result;
}

}  // namespace mq::layered_depth
