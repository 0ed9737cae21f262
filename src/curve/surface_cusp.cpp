// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include "curve/surface_editor.h"

namespace mq::curve {

namespace {

/// Corners whose curved angle is below this part of the straight one are cusps.
constexpr double kCusp = 0.3;
/// Quality that is enough for the triangle in the cusp.
constexpr double kEnough = 0.16;
constexpr std::array<std::array<double, 2>, 4> kWays{{{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}}};

double angle(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double worst(const SurfaceEditor& editor, const std::vector<int>& triangles) {
    double least = 1.0;
    for (const int t : triangles) {
        least = std::min(least, editor.triangle(t).quality);
    }
    return least;
}

}  // namespace

bool open_cusp(SurfaceEditor& editor, int a, int b, int c) {
    Surface& surface = editor.surface;
    if (surface.shapes.order() < 2 || surface.segment(a, b) == nullptr || surface.segment(a, c) == nullptr) {
        return false;
    }
    const std::vector<Vec3> to_b = surface.shapes.edge_inner(a, b);
    const std::vector<Vec3> to_c = surface.shapes.edge_inner(a, c);
    const double curved = angle(to_b.front() - editor.point(a), to_c.front() - editor.point(a));
    if (curved > kCusp * angle(editor.point(b) - editor.point(a), editor.point(c) - editor.point(a))) {
        return false;
    }
    std::vector<int> beside = surface.triangles_of_edge(a, b);
    for (const int t : surface.triangles_of_edge(a, c)) {
        if (std::find(beside.begin(), beside.end(), t) == beside.end()) {
            beside.push_back(t);
        }
    }
    const double before = worst(editor, beside);
    double best = before;
    std::array<double, 2> kept{};
    for (const double by : {0.0, 0.02, 0.04, 0.06, 0.09, 0.12}) {
        // Away from the cusp a node makes its edge leave at a smaller angle to the chord; which is better depends on
        // the sides to which the two edges bend.
        for (const auto& way : kWays) {
            editor.placement.set_quadratic(a, b, 0.5 + way[0] * by);
            editor.placement.set_quadratic(a, c, 0.5 + way[1] * by);
            editor.placement.place(beside);
            const double now = worst(editor, beside);
            if (now > best + 1e-3) {
                best = now;
                kept = {0.5 + way[0] * by, 0.5 + way[1] * by};
            }
        }
        if (best > kEnough) {
            break;
        }
    }
    if (best > before) {
        editor.placement.set_quadratic(a, b, kept[0]);
        editor.placement.set_quadratic(a, c, kept[1]);
    } else {
        surface.shapes.set_edge(a, b, to_b);
        surface.shapes.set_edge(a, c, to_c);
    }
    editor.placement.place(beside);
    return best > before;
}

}  // namespace mq::curve
