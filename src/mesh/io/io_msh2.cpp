// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/io_formats.h"

namespace mq::mesh {

// Gmsh 2.2: each element with its physical group and the CAD entity that it lies on.
void to_msh2(Output& out, const ExportMesh& mesh) {
    std::string names;
    std::size_t groups = 0;
    for (std::size_t dimension = 1; dimension <= 3; ++dimension) {
        for (std::size_t g = 0; g < mesh.groups[dimension].size(); ++g) {
            names += std::to_string(dimension) + " " + std::to_string(g + 1) + " \"" + mesh.groups[dimension][g].name +
                     "\"\n";
            ++groups;
        }
    }
    out += "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" + std::to_string(groups) + "\n" + names +
           "$EndPhysicalNames\n$Nodes\n" + std::to_string(mesh.nodes.size()) + "\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        out.append_number(i + 1);
        out += ' ';
        append_point_text(out, mesh.point(i));
    }
    const auto blocks = mesh.numbered(1);
    out += "$EndNodes\n$Elements\n" + std::to_string(count_of(blocks)) + "\n";
    for (const auto& [block, first] : blocks) {
        const std::string type = " " + std::to_string(block->type->gmsh) + " 2 ";
        for (std::size_t k = 0; k < block->size(); ++k) {
            const std::int32_t group = mesh.first_group(*block, k);
            out.append_number(first + k);
            out += type;
            out.append_number(group + 1);
            out += ' ';
            out.append_number((block->entity.empty() ? group : block->entity[k]) + 1);
            append_nodes(out, block->of(k), block->type->nodes, 1);
        }
    }
    out += "$EndElements\n";
}

}  // namespace mq::mesh
