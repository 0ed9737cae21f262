// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "curve/surface/editor.h"

namespace mq::curve {

namespace {

/// The neighbour of `a` along its CAD edge on the side away from `b`; -1 when there is not exactly one.
int next_along(const CurvedSurface& surface, int a, int b) {
    int found = -1;
    for (const int v : surface.neighbours(a)) {
        if (v != b && surface.segment(a, v) != nullptr) {
            if (found >= 0) {
                return -1;
            }
            found = v;
        }
    }
    return found;
}

bool allowed(const CurvedSurface& surface, int a, int b, int& along) {
    const int dimension = surface.shapes.vertices[static_cast<std::size_t>(a)].entity[0];
    const Segment* segment = surface.segment(a, b);
    if (dimension == 0 || (dimension == 1) != (segment != nullptr)) {
        return false;
    }
    if (dimension == 1) {
        along = next_along(surface, a, b);
        if (along < 0 || surface.segment(a, along)->edge != segment->edge || surface.has_edge(along, b)) {
            return false;
        }
    }
    return surface.link_condition(a, b);
}

}  // namespace

bool collapse_surface_edge(SurfaceEditor& editor, int a, int b, SurfaceEditor::Rule rule) {
    CurvedSurface& surface = editor.surface;
    int along = -1;
    if (!allowed(surface, a, b, along)) {
        return false;
    }
    const std::vector<int> removed = surface.triangles_of_vertex(a);
    std::vector<SurfaceEditor::Corners> added;
    for (const int t : removed) {
        std::array<int, 3> corners = editor.triangle(t).corners;
        if (std::find(corners.begin(), corners.end(), b) == corners.end()) {
            std::replace(corners.begin(), corners.end(), a, b);
            added.push_back({corners, editor.triangle(t).face});
        }
    }
    if (added.empty()) {
        return false;
    }
    if (along >= 0) {
        // Where the vertex lies on the other side of the end of a closed edge, their parameters differ by a turn.
        const double turn = surface.t_of(a, along) - surface.t_of(a, b);
        surface.set_segment(along, b, surface.segment(a, b)->edge, surface.t_of(along, a), surface.t_of(b, a) + turn);
    }
    if (editor.replace(removed, added, rule)) {
        return true;
    }
    if (along >= 0) {
        surface.segments.erase(pair_key(along, b));
    }
    return false;
}

}  // namespace mq::curve
