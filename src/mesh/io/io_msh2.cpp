// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/io_formats.h"

namespace mq::mesh {

int gmsh_type(int dimension, int order) {
    // Gmsh's type numbers; rows: dimension, columns: order.
    static constexpr std::array<std::array<int, 5>, 3> kTypes{
        {{1, 8, 26, 27, 28}, {2, 9, 21, 23, 25}, {4, 11, 29, 30, 31}}};
    return kTypes[static_cast<std::size_t>(dimension - 1)][static_cast<std::size_t>(order - 1)];
}

// Gmsh 2.2: each element with its physical group and the CAD entity that it lies on.
void to_msh2(Output& out, const ExportMesh& mesh) {
    std::string names;
    std::size_t groups = 0;
    std::size_t count = 0;
    for (std::size_t dimension = 1; dimension <= 3; ++dimension) {
        for (std::size_t g = 0; g < mesh.groups[dimension].size(); ++g) {
            names += std::to_string(dimension) + " " + std::to_string(g + 1) + " \"" + mesh.groups[dimension][g].name +
                     "\"\n";
            ++groups;
        }
        count += mesh.elements[dimension].size();
    }
    out += "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" + std::to_string(groups) + "\n" + names +
           "$EndPhysicalNames\n$Nodes\n" + std::to_string(mesh.nodes.size()) + "\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        out.append_number(static_cast<long long>(i) + 1);
        out += ' ';
        append_point_text(out, mesh.point(i));
    }
    out += "$EndNodes\n$Elements\n" + std::to_string(count) + "\n";
    long long number = 0;
    for (std::size_t dimension = 1; dimension <= 3; ++dimension) {
        const Elements& elements = mesh.elements[dimension];
        const std::string type = " " + std::to_string(gmsh_type(static_cast<int>(dimension), mesh.order)) + " 2 ";
        for (std::size_t k = 0; k < elements.size(); ++k) {
            out.append_number(++number);
            out += type;
            out.append_number(static_cast<long long>(elements.group[k]) + 1);
            out += ' ';
            out.append_number(static_cast<long long>(elements.entity.empty() ? elements.group[k] : elements.entity[k]) +
                              1);
            append_nodes(out, elements.of(k), elements.width, 1);
        }
    }
    out += "$EndElements\n";
}

}  // namespace mq::mesh
