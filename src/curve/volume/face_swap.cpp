// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "curve/volume/editor.h"

namespace mq::curve {

bool swap_region_face(VolumeEditor& editor, int a, int b, int c, VolumeEditor::Rule rule) {
    if (editor.volume.fixed_face(a, b, c)) {
        return false;
    }
    const std::vector<int> beside = editor.volume.of_face(a, b, c);
    if (beside.size() != 2) {
        return false;
    }
    const auto opposite = [&](int t) {
        const auto& corners = editor.tetrahedron(t).corners;
        return *std::find_if(corners.begin(), corners.end(), [&](int v) { return v != a && v != b && v != c; });
    };
    int p = opposite(beside[0]);
    int q = opposite(beside[1]);
    if (editor.volume.has_edge(p, q)) {
        return false;
    }
    if (editor.volume.straight_jacobian({a, b, c, p}) < 0.0) {
        std::swap(p, q);
    }
    return editor.replace(beside, {{a, b, q, p}, {b, c, q, p}, {c, a, q, p}}, rule);
}

}  // namespace mq::curve
