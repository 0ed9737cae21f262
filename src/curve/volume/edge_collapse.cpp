// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <set>

#include "curve/volume/editor.h"

namespace mq::curve {

namespace {

std::set<int> neighbours(const TetrahedralMesh& volume, int v) {
    std::set<int> result;
    for (const int t : volume.of_vertex(v)) {
        const auto& corners = volume.tetrahedra[static_cast<std::size_t>(t)].corners;
        result.insert(corners.begin(), corners.end());
    }
    result.erase(v);
    return result;
}

/// Vertices that neighbour both ends must form faces with the edge, or the collapse would join separate regions.
bool link_condition(const TetrahedralMesh& volume, int a, int b) {
    std::set<int> ring;
    for (const int t : volume.of_edge(a, b)) {
        const auto& corners = volume.tetrahedra[static_cast<std::size_t>(t)].corners;
        ring.insert(corners.begin(), corners.end());
    }
    const std::set<int> of_a = neighbours(volume, a);
    const std::set<int> of_b = neighbours(volume, b);
    return std::all_of(of_a.begin(), of_a.end(), [&](int v) { return of_b.count(v) == 0 || ring.count(v) > 0; });
}

}  // namespace

bool collapse_region_edge(VolumeEditor& editor, int a, int b) {
    const TetrahedralMesh& volume = editor.volume;
    if (volume.shapes().vertices[static_cast<std::size_t>(a)].entity[0] != 3 || !link_condition(volume, a, b)) {
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
