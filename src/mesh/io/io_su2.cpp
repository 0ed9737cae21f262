// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/io_formats.h"

namespace mq::mesh {

// SU2 numbers types of elements as VTK does, and nodes from 0. A mesh without volumes has its faces as markers only.
void to_su2(Output& out, const ExportMesh& mesh) {
    const auto append = [&](const Elements& block, std::size_t k, std::string_view end) {
        out.append_number(block.type->vtk);
        append_nodes(out, block.of(k), block.type->nodes, 0, ' ', end);
    };
    const auto volumes = mesh.numbered(3);
    out += "% MeshQuality\nNDIME= 3\nNELEM= " + std::to_string(count_of(volumes)) + "\n";
    for (const auto& [block, first] : volumes) {
        for (std::size_t k = 0; k < block->size(); ++k) {
            append(*block, k, " ");
            out.append_number(first - 1 + k);
            out += '\n';
        }
    }
    out += "NPOIN= " + std::to_string(mesh.nodes.size()) + "\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_point_text(out, mesh.point(i), " ");
        out.append_number(i);
        out += '\n';
    }
    const int dimension = std::min(mesh.dimension(), 2);
    const auto faces = mesh.numbered(dimension, dimension);
    const auto markers = divided(mesh, faces);
    out += "NMARK= " + std::to_string(markers.size()) + "\n";
    for (const Members& marker : markers) {
        out += "MARKER_TAG= " + marker.name + "\nMARKER_ELEMS= " + std::to_string(marker.elements.size()) + "\n";
        for (const auto& [block, k] : marker.elements) {
            append(*block->elements, static_cast<std::size_t>(k), "\n");
        }
    }
}

}  // namespace mq::mesh
