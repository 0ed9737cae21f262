// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angle.h"
#include "base/tuning.h"
#include "curve/surface/editor.h"
#include "curve/surface/tuning.h"

namespace mq::curve {

namespace {

double worst(const SurfaceEditor& editor, const std::vector<int>& triangles) {
    double least = 1.0;
    for (const int t : triangles) {
        least = std::min(least, editor.triangle(t).quality);
    }
    return least;
}

/// Displacements of the nodes of the two edges, and the degree of the edges.
struct Warp {
    int degree = 2;
    std::array<double, 2> by{};
};

/// The warps to try, those that stay nearest to the CAD first: high degrees before low ones, small displacements before
/// large. Moving a node away from the cusp makes its edge leave at a smaller angle to the chord; which is better
/// depends on the sides to which the two edges bend.
std::vector<Warp> warps(int order) {
    // Combinations of directions in which the nodes of the two edges move along their edges.
    constexpr std::array<std::array<double, 2>, 4> kWays{{{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}}};
    std::vector<Warp> result;
    for (int degree = order; degree >= 2; --degree) {
        for (const double by : {0.0, 0.02, 0.04, 0.06, 0.09, 0.12}) {
            for (const auto& way : kWays) {
                result.push_back({degree, {way[0] * by, way[1] * by}});
            }
        }
    }
    return result;
}

/// Halves both edges of the cusp. The deviation that the opening costs falls with the third power of their length, or
/// faster. The edge that bends more comes first: a line from its end to the middle of the other would touch it.
bool refine(SurfaceEditor& editor, int a, int b, int c) {
    if (editor.deviation(a, b) < editor.deviation(a, c)) {
        std::swap(b, c);
    }
    const bool first = split_surface_edge(editor, a, b, SurfaceEditor::Rule::RefinePoor) >= 0;
    const bool second = split_surface_edge(editor, a, c, SurfaceEditor::Rule::RefinePoor) >= 0;
    return first || second;
}

}  // namespace

CuspRepair open_cusp(SurfaceEditor& editor, int a, int b, int c) {
    CurvedSurface& surface = editor.surface;
    if (surface.shapes.order() < 2 || surface.segment(a, b) == nullptr || surface.segment(a, c) == nullptr) {
        return CuspRepair::None;
    }
    const std::vector<Vec3> to_b = surface.shapes.edge_inner(a, b);
    const std::vector<Vec3> to_c = surface.shapes.edge_inner(a, c);
    const double curved = angle_between(to_b.front() - editor.point(a), to_c.front() - editor.point(a));
    const double straight = angle_between(editor.point(b) - editor.point(a), editor.point(c) - editor.point(a));
    if (curved > SurfaceTuning::kCuspShare * straight) {
        return CuspRepair::None;
    }
    std::vector<int> beside = surface.triangles_of_edge(a, b);
    for (const int t : surface.triangles_of_edge(a, c)) {
        if (std::find(beside.begin(), beside.end(), t) == beside.end()) {
            beside.push_back(t);
        }
    }
    const double before = worst(editor, beside);
    double best = before;
    Warp kept;
    const auto apply = [&](const Warp& warp) {
        editor.placement.set_warped(a, b, warp.by[0], warp.degree);
        editor.placement.set_warped(a, c, warp.by[1], warp.degree);
        editor.placement.place(beside);
    };
    for (const Warp& warp : warps(surface.shapes.order())) {
        apply(warp);
        const double now = worst(editor, beside);
        if (now > best + kLeastGain) {
            best = now;
            kept = warp;
        }
        if (best > SurfaceTuning::kCuspQuality) {
            break;
        }
    }
    if (best > before) {
        apply(kept);
        if (0.5 * straight < SurfaceTuning::kThinnestCusp ||
            editor.rms_deviation(beside) <= SurfaceTuning::kCuspDeviation * editor.plain_deviation()) {
            return CuspRepair::Opened;
        }
    }
    surface.shapes.set_edge(a, b, to_b);
    surface.shapes.set_edge(a, c, to_c);
    editor.placement.place(beside);
    if (best > before && refine(editor, a, b, c)) {
        return CuspRepair::Refined;
    }
    if (!(best > before)) {
        return CuspRepair::None;
    }
    apply(kept);
    return CuspRepair::Opened;
}

}  // namespace mq::curve
