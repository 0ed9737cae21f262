// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include "curve/surface_editor.h"

namespace mq::curve {

namespace {

/// Epsilon of (7), as a part of |t2 x t1|^2: how much of the straight triangle's corner is asked back.
constexpr double kEpsilon = 0.3;

/// Control points of the edge from a to b moved by the quadratic bubble 4 s (1 - s) times `by`.
std::vector<Vec3> bulged(const std::vector<Vec3>& inner, const Vec3& by) {
    // In Bernstein form 4 s (1 - s) has the coefficients 4 k (q - k) / (q (q - 1)).
    const double q = static_cast<double>(inner.size()) + 1.0;
    std::vector<Vec3> result = inner;
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const double k = static_cast<double>(i) + 1.0;
        result[i] += by * (4.0 * k * (q - k) / (q * (q - 1.0)));
    }
    return result;
}

double worst(const SurfaceEditor& editor, const std::vector<int>& triangles) {
    double least = 1.0;
    for (const int t : triangles) {
        least = std::min(least, editor.triangle(t).quality);
    }
    return least;
}

}  // namespace

bool curve_face_edge(SurfaceEditor& editor, int a, int b, int c) {
    Surface& surface = editor.surface;
    const double order = surface.shapes.order();
    if (order < 2 || surface.segment(a, b) != nullptr || !surface.shapes.has_edge(a, c)) {
        return false;
    }
    const std::vector<int> beside = surface.triangles_of_edge(a, b);
    const int face = editor.triangle(beside.front()).face;
    if (!editor.placement.planar(face)) {
        return false;  // inside curved faces the nodes belong to the surface
    }
    const Vec3 t1 = editor.point(c) - editor.point(a);
    const Vec3 t2 = editor.point(b) - editor.point(a);
    const std::vector<Vec3> border = surface.shapes.edge_inner(a, c);
    const Vec3 t3 = order * (border.front() - editor.point(a));
    Vec3 s = border[border.size() / 2] - 0.5 * (editor.point(a) + editor.point(c));
    s -= t1 * (s.dot(t1) / t1.squaredNorm());
    if (!(s.norm() > 1e-9 * t1.norm())) {
        return false;
    }
    s.normalize();
    const Vec3 straight = t2.cross(t1);
    const double slope = 4.0 * straight.dot(s.cross(t3));
    if (!(std::abs(slope) > 0.0)) {
        return false;
    }
    const double m = (kEpsilon * straight.squaredNorm() - straight.dot(t2.cross(t3))) / slope;  // (9)
    const bool had = surface.shapes.has_edge(a, b);
    const std::vector<Vec3> before = surface.shapes.edge_inner(a, b);
    const double quality = worst(editor, beside);
    for (const double part : {1.0, 0.6, 1.5}) {
        surface.shapes.set_edge(a, b, bulged(before, part * m * s));
        editor.placement.measure(beside);
        if (worst(editor, beside) > quality + 1e-3) {
            return true;
        }
    }
    if (had) {
        surface.shapes.set_edge(a, b, before);
    } else {
        surface.shapes.forget_edge(a, b);
    }
    editor.placement.measure(beside);
    return false;
}

}  // namespace mq::curve
