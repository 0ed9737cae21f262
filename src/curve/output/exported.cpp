// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <map>

#include "curve/output/curved_mesh.h"

namespace mq::curve {

std::string name_of(int dimension, int index) {
    // FreeCAD's names of entities, by dimension.
    static constexpr std::array<const char*, 4> kNames{"Vertex", "Edge", "Face", "Solid"};
    return kNames[static_cast<std::size_t>(dimension)] + std::to_string(index + 1);
}

namespace {

/// Puts elements that are grouped by the CAD entity on which they lie into the mesh.
void add_elements(mesh::ExportMesh& made, std::size_t dimension, int width, const std::vector<std::int32_t>& nodes,
                  const std::vector<std::int32_t>& entity) {
    mesh::Elements& elements = made.elements[dimension];
    elements.width = static_cast<std::size_t>(width);
    elements.nodes = nodes;
    elements.entity = entity;
    std::map<std::int32_t, std::int32_t> number;
    for (const std::int32_t index : entity) {
        number.try_emplace(index, 0);
    }
    for (auto& [index, group] : number) {
        group = static_cast<std::int32_t>(made.groups[dimension].size());
        made.groups[dimension].push_back({name_of(static_cast<int>(dimension), index)});
    }
    for (const std::int32_t index : entity) {
        elements.group.push_back(number[index]);
    }
}

}  // namespace

mesh::ExportMesh exported(const CurvedMesh& mesh, const mesh::Patches& patches, double scale) {
    mesh::ExportMesh made;
    made.scale = scale;
    made.nodes = mesh.nodes;
    made.node_entity = mesh.node_entity;
    made.corners = mesh.vertices;
    made.order = mesh.order;
    add_elements(made, 1, mesh.nodes_per_edge(), mesh.edges, mesh.edge_entity);
    add_elements(made, 2, mesh.nodes_per_triangle(), mesh.triangles, mesh.triangle_face);
    add_elements(made, 3, mesh.nodes_per_tetrahedron(), mesh.tetrahedra, mesh.tetrahedron_volume);
    if (!patches.groups.empty()) {
        mesh::set_patches(made, patches);
    }
    if (!mesh.tetrahedra.empty()) {
        made.behind = tetrahedra_behind(mesh);
    }
    return made;
}

}  // namespace mq::curve
