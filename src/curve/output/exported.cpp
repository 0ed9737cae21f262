// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <map>

#include "curve/output/curved_mesh.h"
#include "elements/product/reference_nodes.h"

namespace mq::curve {

using elements::Lattice;

namespace {

/// By place in the order of VTK's Lagrange cells the place in Gmsh's.
std::vector<std::size_t> lagrange_order(const Lattice& lattice) {
    const std::vector<int> gmsh = elements::gmsh_order(lattice);
    std::vector<std::size_t> place(gmsh.size());
    for (std::size_t i = 0; i < gmsh.size(); ++i) {
        place[static_cast<std::size_t>(gmsh[i])] = i;
    }
    std::vector<std::size_t> result;
    for (const int point : elements::vtk_order(lattice)) {
        result.push_back(place[static_cast<std::size_t>(point)]);
    }
    return result;
}

/// Puts elements that are grouped by the CAD entity on which they lie into the mesh.
void add_elements(mesh::ExportMesh& made, int dimension, const CurvedMesh& mesh, const std::vector<std::int32_t>& nodes,
                  const std::vector<std::int32_t>& entity) {
    static constexpr std::array<const char*, 4> kKinds{"", "line", "triangle", "tetrahedron"};
    const Lattice& lattice = Lattice::of(dimension, mesh.order);
    std::vector<mesh::Group>& groups = made.groups[static_cast<std::size_t>(dimension)];
    mesh::Elements& elements = made.blocks.emplace_back();
    elements.type =
        &mesh::element_type(kKinds[static_cast<std::size_t>(dimension)], static_cast<std::size_t>(lattice.size()));
    elements.nodes = nodes;
    elements.entity = entity;
    if (dimension > 1) {
        elements.lagrange = lagrange_order(lattice);
    }
    std::map<std::int32_t, std::int32_t> number;
    for (const std::int32_t index : entity) {
        number.try_emplace(index, 0);
    }
    for (auto& [index, group] : number) {
        group = static_cast<std::int32_t>(groups.size());
        groups.push_back({mesh::entity_name(dimension, index)});
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
    made.nodes_by_entity = true;
    add_elements(made, 1, mesh, mesh.edges, mesh.edge_entity);
    add_elements(made, 2, mesh, mesh.triangles, mesh.triangle_face);
    add_elements(made, 3, mesh, mesh.tetrahedra, mesh.tetrahedron_volume);
    if (!patches.groups.empty()) {
        mesh::set_patches(made, patches);
    }
    return made;
}

}  // namespace mq::curve
