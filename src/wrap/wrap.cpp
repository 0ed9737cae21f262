// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/wrap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "contour/contour.h"
#include "contour/simplification.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "option_ranges.h"
#include "wrap/lattice/tuning.h"
#include "wrap/outside/rolling_ball.h"
#include "wrap/outside/thin_material.h"
#include "wrap/surface/crossings.h"

namespace mq::wrap {

namespace {

/// The patch of each triangle: the CAD face that it lies on, and one for closed gaps.
std::vector<std::int32_t> patches_of(const contour::Contour& surface, const mesh::TriangleMesh& input) {
    std::vector<std::int32_t> patch;
    for (const std::int32_t source : surface.source) {
        patch.push_back(source < 0 || input.triangle_face.empty()
                            ? std::min(source, 0)
                            : input.triangle_face[static_cast<std::size_t>(source)]);
    }
    return patch;
}

contour::CollapseLimits limits_for(double spacing) {
    contour::CollapseLimits limits;
    limits.distance = WrapTuning::kSimplification * spacing;
    limits.border = WrapTuning::kBorder * spacing;
    limits.longest = WrapTuning::kLongest * spacing;
    return limits;
}

}  // namespace

void WrapOptions::validate() const {
    ranges::wrap::kGap.require(gap);
    if (!(spacing > 0.0 && spacing <= 0.5 * gap)) {
        throw InvalidInput(phrases::kWrapSpacing, {{"length", in_mm(spacing)}, {"length2", in_mm(gap)}});
    }
    ranges::wrap::kThreads.require(threads);
}

WrapResult wrap(const mesh::TriangleMesh& input, const WrapOptions& options, Progress& progress) {
    options.validate();
    if (input.triangles.empty()) {
        throw InvalidInput(phrases::kNothingToWrap);
    }
    const ThreadLimit limit(options.threads);
    WrapResult result;
    WatchedStageTimer watch(progress, result.seconds);

    watch.start("classifying nodes", 0.0, 0.15);
    const InputSurface surface(input.vertices, input.triangles);
    // Points of an edge are at most half a side nearer to the input than the ends of the edge.
    const double radius = 0.5 * options.gap + 0.5 * options.spacing;
    const Lattice lattice(surface.tree.box(), radius + 2.0 * options.spacing, options.spacing);
    NodeStates states(lattice, surface, radius, progress);

    watch.start("rolling the ball", 0.15, 0.28);
    roll_ball(states, 0.5 * options.gap, progress);
    for (const Vec3& dry : options.dry) {
        if (std::optional<Leak> leak = find_leak(states, dry, progress)) {
            result.leaks.push_back(std::move(*leak));
        }
    }
    watch.start("rolling the ball", 0.28, 0.3);
    move_into_thin_material(states, progress);
    result.sheet_nodes = mark_sheets(states, progress);

    watch.start("contouring", 0.3, 0.45);
    const contour::CrossedCells cells = find_crossings(states, input.triangle_face, progress);
    contour::Contour between = contour::contour(cells, nullptr, progress);

    watch.start("simplifying", 0.45, 0.8);
    between.patch = patches_of(between, input);
    contour::simplify(between, cells.crossings, limits_for(options.spacing), WrapTuning::kBlock * options.spacing,
                      progress);
    result.mesh.origin = input.origin;
    result.mesh.vertices = std::move(between.points);
    result.mesh.triangles = std::move(between.triangles);
    result.triangle_source = std::move(between.source);

    watch.start("measuring distances", 0.8, 1.0);
    result.distance = wrap_distance(result.mesh, result.triangle_source, surface, options.spacing, progress);
    watch.end();
    return result;
}

}  // namespace mq::wrap
