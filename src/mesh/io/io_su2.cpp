// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/io_formats.h"

namespace mq::mesh {

// SU2 numbers types of elements as VTK does, and nodes from 0. A mesh without tetrahedra has its triangles as markers
// only.
void to_su2(Output& out, const ExportMesh& mesh) {
    constexpr const char* kTriangle = "5";
    constexpr const char* kTetrahedron = "10";
    const Elements& tetrahedra = mesh.tetrahedra();
    out += "% MeshQuality\nNDIME= 3\nNELEM= " + std::to_string(tetrahedra.size()) + "\n";
    for (std::size_t e = 0; e < tetrahedra.size(); ++e) {
        out += kTetrahedron;
        append_nodes(out, tetrahedra.of(e), 4, 0, ' ', " ");
        out.append_number(static_cast<long long>(e));
        out += '\n';
    }
    out += "NPOIN= " + std::to_string(mesh.nodes.size()) + "\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_point_text(out, mesh.point(i), " ");
        out.append_number(static_cast<long long>(i));
        out += '\n';
    }
    const auto patches = mesh.triangles().by_group(mesh.patches().size());
    out += "NMARK= " + std::to_string(patches.size()) + "\n";
    for (std::size_t p = 0; p < patches.size(); ++p) {
        out += "MARKER_TAG= " + mesh.patches()[p].name + "\nMARKER_ELEMS= " + std::to_string(patches[p].size()) + "\n";
        for (const std::int32_t k : patches[p]) {
            out += kTriangle;
            append_nodes(out, mesh.triangles().of(static_cast<std::size_t>(k)), 3, 0);
        }
    }
}

}  // namespace mq::mesh
