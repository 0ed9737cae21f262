// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "curve/surface/editor.h"
#include "curve/surface/tuning.h"

namespace mq::curve {

namespace {

/// Corners of triangles that may deviate from the CAD, but are counted as on it.
std::set<int> candidates(const SurfaceEditor& editor, const std::set<int>& triangles) {
    std::set<int> result;
    for (const int t : triangles) {
        for (const int v : editor.triangle(t).corners) {
            if (editor.surface.off_cad.count(v) == 0 && editor.placement.may_be_off_cad(v)) {
                result.insert(v);
            }
        }
    }
    return result;
}

std::set<int> triangles_at(const SurfaceEditor& editor, const std::set<int>& vertices) {
    std::set<int> result;
    for (const int v : vertices) {
        const std::vector<int>& star = editor.surface.triangles_of_vertex(v);
        result.insert(star.begin(), star.end());
    }
    return result;
}

/// The quality of a set of triangles: fewer invalid ones come before a better worst one.
struct State {
    int invalid = 0;
    double worst = 1.0;

    State(const SurfaceEditor& editor, const std::vector<int>& triangles) {
        for (const int t : triangles) {
            const double quality = editor.triangle(t).quality;
            invalid += quality > 0.0 ? 0 : 1;
            worst = std::min(worst, quality);
        }
    }
    bool better_than(const State& other) const {
        return invalid < other.invalid ||
               (invalid == other.invalid && worst > other.worst + SurfaceTuning::kLeastQualityGain);
    }
};

bool reach(SurfaceEditor& editor, const std::set<int>& vertices) {
    CurvedSurface& surface = editor.surface;
    const std::set<int> at = triangles_at(editor, vertices);
    const std::vector<int> around(at.begin(), at.end());
    const State before(editor, around);
    std::vector<std::pair<std::pair<int, int>, std::vector<Vec3>>> edges;
    for (const int t : around) {
        const auto& v = editor.triangle(t).corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = v[k];
            const int b = v[(k + 1) % 3];
            if ((vertices.count(a) > 0 || vertices.count(b) > 0) && surface.shapes.has_edge(a, b)) {
                edges.push_back({{a, b}, surface.shapes.edge_inner(a, b)});
                surface.shapes.forget_edge(a, b);
            }
        }
    }
    surface.off_cad.insert(vertices.begin(), vertices.end());
    editor.placement.place(around);
    if (State(editor, around).better_than(before)) {
        return true;
    }
    for (const int v : vertices) {
        surface.off_cad.erase(v);
    }
    for (const auto& [ends, inner] : edges) {
        surface.shapes.set_edge(ends.first, ends.second, inner);
    }
    editor.placement.place(around);
    return false;
}

}  // namespace

int relax_to_off_cad_vertices(SurfaceEditor& editor, int triangle) {
    const std::set<int> corners = candidates(editor, {triangle});
    if (corners.empty() || editor.triangle(triangle).quality > SurfaceTuning::kGoodTriangle) {
        return 0;
    }
    if (reach(editor, corners)) {
        return static_cast<int>(corners.size());
    }
    std::set<int> bad;
    for (const int t : triangles_at(editor, corners)) {
        if (editor.triangle(t).quality <= SurfaceTuning::kGoodTriangle) {
            bad.insert(t);
        }
    }
    const std::set<int> more = candidates(editor, bad);
    return more != corners && reach(editor, more) ? static_cast<int>(more.size()) : 0;
}

}  // namespace mq::curve
