// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "curve/surface/editor.h"

namespace mq::curve {

bool swap_surface_edge(SurfaceEditor& editor, int a, int b) {
    CurvedSurface& surface = editor.surface;
    if (surface.segment(a, b) != nullptr) {
        return false;
    }
    const std::vector<int> beside = surface.triangles_of_edge(a, b);
    if (beside.size() != 2 || editor.triangle(beside[0]).face != editor.triangle(beside[1]).face) {
        return false;
    }
    const auto& first = editor.triangle(beside[0]).corners;
    const auto& second = editor.triangle(beside[1]).corners;
    const auto at = static_cast<std::size_t>(std::find(first.begin(), first.end(), a) - first.begin());
    if (first[(at + 1) % 3] != b) {
        std::swap(a, b);  // now the first triangle runs from a to b
    }
    const auto opposite = [&](const std::array<int, 3>& corners) {
        return *std::find_if(corners.begin(), corners.end(), [&](int v) { return v != a && v != b; });
    };
    const int c = opposite(first);
    const int d = opposite(second);
    if (c == d || surface.has_edge(c, d)) {
        return false;
    }
    const int face = editor.triangle(beside[0]).face;
    return editor.replace(beside, {{{a, d, c}, face}, {{d, b, c}, face}}, SurfaceEditor::Rule::Improve);
}

}  // namespace mq::curve
