// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

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

/// The displacements m s of the middle of (a, b) by equations (7) to (9), for two directions s in the face: across (a,
/// c), as the middle of that edge left its chord, and across (a, b) itself, which has least effect at its other end.
/// None where the corner is open enough already.
std::vector<Vec3> displacements(const SurfaceEditor& editor, int a, int b, int c) {
    const CurvedShapes& shapes = editor.surface.shapes;
    const double order = shapes.order();
    const Vec3 t1 = editor.point(c) - editor.point(a);
    const Vec3 t2 = editor.point(b) - editor.point(a);
    const Vec3 t3 = order * (shapes.edge_inner(a, c).front() - editor.point(a));
    const Vec3 t4 = order * (shapes.edge_inner(a, b).front() - editor.point(a));
    const Vec3 straight = t2.cross(t1);
    const double missing = SurfaceTuning::kRestoredCorner * straight.squaredNorm() - straight.dot(t4.cross(t3));
    std::vector<Vec3> result;
    for (const Vec3& along : {t1, t2}) {
        const Vec3 s = straight.cross(along).normalized();
        const double slope = 4.0 * straight.dot(s.cross(t3));
        const Vec3 by = missing / slope * s;  // (9)
        if (missing > 0.0 && by.allFinite()) {
            result.push_back(by);
        }
    }
    return result;
}

}  // namespace

bool curve_face_edge(SurfaceEditor& editor, int a, int b, int c) {
    CurvedSurface& surface = editor.surface;
    if (surface.shapes.order() < 2 || surface.segment(a, b) != nullptr || !surface.shapes.has_edge(a, c)) {
        return false;
    }
    const std::vector<Vec3> ways = displacements(editor, a, b, c);
    if (ways.empty()) {
        return false;
    }
    const std::vector<int> beside = surface.triangles_of_edge(a, b);
    const int face = editor.triangle(beside.front()).face;
    const bool had = surface.shapes.has_edge(a, b);
    const std::vector<Vec3> before = surface.shapes.edge_inner(a, b);
    const auto restore = [&] {
        if (had) {
            surface.shapes.set_edge(a, b, before);
        } else {
            surface.shapes.forget_edge(a, b);
        }
    };
    const double quality = worst(editor, beside);
    for (const Vec3& by : ways) {
        for (const double part : {1.0, 0.6, 1.5}) {
            if (editor.placement.bulge_on_face(a, b, face, part * by)) {
                editor.placement.place(beside);
                if (worst(editor, beside) > quality + SurfaceTuning::kLeastQualityGain) {
                    return true;
                }
            }
            restore();
        }
    }
    editor.placement.place(beside);
    return false;
}

}  // namespace mq::curve
