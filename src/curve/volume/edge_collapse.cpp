// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "curve/volume/editor.h"

namespace mq::curve {

bool collapse_region_edge(VolumeEditor& editor, int a, int b) {
    const TetrahedralMesh& volume = editor.volume;
    if (volume.shapes().vertices[static_cast<std::size_t>(a)].entity[0] != 3 || !volume.link_condition(a, b)) {
        return false;
    }
    const std::vector<int> removed = volume.of_vertex(a);
    std::vector<std::array<int, 4>> added;
    for (const int t : removed) {
        std::array<int, 4> corners = editor.tetrahedron(t).corners;
        if (std::find(corners.begin(), corners.end(), b) == corners.end()) {
            std::replace(corners.begin(), corners.end(), a, b);
            added.push_back(corners);
        }
    }
    return !added.empty() && editor.replace(removed, added, VolumeEditor::Rule::Improve);
}

}  // namespace mq::curve
