// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/checks.h"
#include "given/matching/given_mesh.h"

namespace mq::given {

/// The corners of a mesh of ours, as if another program had made it: nothing says on which CAD entities they lie.
inline GivenMesh given_of(const curve::CurvedMesh& mesh) {
    GivenMesh given;
    given.nodes.assign(mesh.nodes.begin(), mesh.nodes.begin() + static_cast<std::ptrdiff_t>(mesh.vertices));
    const auto add = [](const std::vector<std::int32_t>& nodes, int width, auto& elements) {
        for (std::size_t first = 0; first < nodes.size(); first += static_cast<std::size_t>(width)) {
            elements.emplace_back();
            std::copy_n(nodes.begin() + static_cast<std::ptrdiff_t>(first), elements.back().size(),
                        elements.back().begin());
        }
    };
    add(mesh.triangles, mesh.nodes_per_triangle(), given.triangles);
    add(mesh.tetrahedra, mesh.nodes_per_tetrahedron(), given.tetrahedra);
    given.regions.assign(mesh.tetrahedron_volume.begin(), mesh.tetrahedron_volume.end());
    return given;
}

}  // namespace mq::given
