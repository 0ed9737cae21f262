// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "curve/surface/editor.h"

namespace mq::curve {

int split_surface_edge(SurfaceEditor& editor, int a, int b, SurfaceEditor::Rule rule) {
    CurvedSurface& surface = editor.surface;
    const std::vector<int> removed = surface.triangles_of_edge(a, b);
    const Placement::Middle middle = editor.placement.middle_of(a, b);
    if (!middle.found) {
        return -1;
    }
    const int p = surface.add_vertex(middle.vertex);
    for (const auto& [face, uv] : middle.uv) {
        surface.uv.emplace(CurvedSurface::key(p, face), uv);
    }
    if (const Segment* segment = surface.segment(a, b)) {
        const int edge = segment->edge;
        const double t_a = surface.t_of(a, b);
        const double t_b = surface.t_of(b, a);
        surface.set_segment(a, p, edge, t_a, middle.t);
        surface.set_segment(p, b, edge, middle.t, t_b);
    }
    std::vector<SurfaceEditor::Corners> added;
    for (const int t : removed) {
        for (const int end : {a, b}) {
            std::array<int, 3> corners = editor.triangle(t).corners;
            std::replace(corners.begin(), corners.end(), end, p);
            added.push_back({corners, editor.triangle(t).face});
        }
    }
    if (editor.replace(removed, added, rule)) {
        return p;
    }
    return -1;
}

}  // namespace mq::curve
