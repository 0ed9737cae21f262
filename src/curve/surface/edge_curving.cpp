// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

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
    const elements::CurvedShapes& shapes = editor.surface.shapes;
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

std::size_t invalid(const SurfaceEditor& editor, const std::vector<int>& triangles) {
    return static_cast<std::size_t>(
        std::count_if(triangles.begin(), triangles.end(), [&](int t) { return !(editor.triangle(t).quality > 0.0); }));
}

/// Curves the edges of a group of triangles of one face along parameter lines; undoes it unless fewer of them are
/// invalid.
bool follow_together(SurfaceEditor& editor, const std::vector<int>& triangles, int face) {
    CurvedSurface& surface = editor.surface;
    std::map<std::pair<int, int>, std::vector<Vec3>> before;
    std::set<int> beside(triangles.begin(), triangles.end());
    for (const int t : triangles) {
        const std::array<int, 3> v = editor.triangle(t).corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::pair<int, int> edge = std::minmax(v[k], v[(k + 1) % 3]);
            if (surface.segment(edge.first, edge.second) != nullptr || before.count(edge) > 0) {
                continue;
            }
            const std::vector<Vec3> inner = surface.shapes.edge_inner(edge.first, edge.second);
            if (editor.placement.place_by_parameters(edge.first, edge.second, face)) {
                before.emplace(edge, inner);
                const std::vector<int> both = surface.triangles_of_edge(edge.first, edge.second);
                beside.insert(both.begin(), both.end());
            }
        }
    }
    const std::vector<int> all(beside.begin(), beside.end());
    const std::size_t invalid_before = invalid(editor, all);
    const double quality = worst(editor, all);
    editor.placement.place(all);
    const std::size_t invalid_after = invalid(editor, all);
    if (invalid_after < invalid_before ||
        (invalid_after == invalid_before && worst(editor, all) > quality + SurfaceTuning::kLeastQualityGain)) {
        return true;
    }
    for (const auto& [edge, inner] : before) {
        surface.shapes.set_edge(edge.first, edge.second, inner);
    }
    editor.placement.place(all);
    return false;
}

}  // namespace

bool follow_parameters(SurfaceEditor& editor, int triangle) {
    const SurfaceTriangle& centre = editor.triangle(triangle);
    if (editor.surface.shapes.order() < 2 || editor.placement.planar(centre.face)) {
        return false;
    }
    if (follow_together(editor, {triangle}, centre.face)) {
        return true;
    }
    // Edges that follow the parameters may cross neighbours that do not.
    std::set<int> around;
    for (const int v : centre.corners) {
        for (const int t : editor.surface.triangles_of_vertex(v)) {
            if (editor.triangle(t).face == centre.face) {
                around.insert(t);
            }
        }
    }
    return follow_together(editor, {around.begin(), around.end()}, centre.face);
}

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
