// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "base/error.h"
#include "curve/output/curved_mesh.h"
#include "elements/bezier/node_orders.h"
#include "mesh/io/io.h"
#include "mesh/io/io_formats.h"

namespace mq::curve {

namespace {

/// VTK's number of the elements. Orders 1 and 2 have cells of their own, which more programs can read than Lagrange
/// cells, FreeCAD's FEM among them.
int cell_type(int dimension, int order) {
    // VTK's cell types of triangles and tetrahedra, by order; the last are Lagrange cells.
    constexpr int kTypes[2][3] = {{5, 22, 69}, {10, 24, 71}};
    return kTypes[dimension - 2][std::min(order, 3) - 1];
}

void append_array(mesh::Output& out, const char* type, const char* name, const std::vector<std::int32_t>& values) {
    out += std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" format=\"ascii\">\n";
    for (const std::int32_t value : values) {
        out.append_number(value);
        out += '\n';
    }
    out += "</DataArray>\n";
}

/// Reorders the elements' nodes from Gmsh's order to VTK's.
std::vector<std::int32_t> reordered(const std::vector<std::int32_t>& nodes, const Lattice& lattice) {
    const std::vector<int> gmsh = gmsh_order(lattice);
    const std::vector<int> vtk = vtk_order(lattice);
    std::vector<std::size_t> place(gmsh.size());
    for (std::size_t i = 0; i < gmsh.size(); ++i) {
        place[static_cast<std::size_t>(gmsh[i])] = i;
    }
    std::vector<std::int32_t> result;
    result.reserve(nodes.size());
    for (std::size_t from = 0; from < nodes.size(); from += gmsh.size()) {
        for (const int point : vtk) {
            result.push_back(nodes[from + place[static_cast<std::size_t>(point)]]);
        }
    }
    return result;
}

void append_points(mesh::Output& out, const mesh::ExportMesh& mesh) {
    out += "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        mesh::append_point_text(out, mesh.point(i));
    }
    out += "</DataArray>\n</Points>\n";
}

}  // namespace

void curved_vtu(mesh::Output& out, const mesh::ExportMesh& mesh) {
    const bool volume = mesh.tetrahedra().size() > 0;
    const Lattice& lattice = Lattice::of(volume ? 3 : 2, mesh.order);
    const mesh::Elements& elements = volume ? mesh.tetrahedra() : mesh.triangles();
    const std::vector<std::int32_t>& entity = elements.entity;
    std::vector<std::int32_t> offsets;
    for (std::size_t i = 1; i <= entity.size(); ++i) {
        offsets.push_back(static_cast<std::int32_t>(i) * lattice.size());
    }
    const std::vector<std::int32_t> types(entity.size(), cell_type(volume ? 3 : 2, mesh.order));
    out +=
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" byte_order=\"LittleEndian\">\n"
        "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
        std::to_string(mesh.nodes.size()) + "\" NumberOfCells=\"" + std::to_string(entity.size()) + "\">\n<CellData>\n";
    append_array(out, "Int32", volume ? "cad_solid" : "cad_face", entity);
    if (mesh.patches_given && !volume) {
        append_array(out, "Int32", "patch", elements.group);
    }
    out += "</CellData>\n";
    append_points(out, mesh);
    out += "<Cells>\n";
    append_array(out, "Int32", "connectivity", reordered(elements.nodes, lattice));
    append_array(out, "Int32", "offsets", offsets);
    append_array(out, "UInt8", "types", types);
    out += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

void write_curved(const mesh::ExportMesh& mesh, const std::string& path, const std::string& format) {
    if (format == "msh" || format == "vtu") {
        mesh::save(path, [&](mesh::Output& out) { format == "msh" ? curved_msh(out, mesh) : curved_vtu(out, mesh); });
    } else {
        mesh::write(mesh, path, format);
    }
}

void write(const CurvedMesh& mesh, const std::string& path) {
    const std::string extension = mesh::extension_of(path);
    if (extension != ".msh" && extension != ".vtu") {
        throw IoError("'" + path + "' has no known extension: curved meshes are written as .msh or .vtu");
    }
    write_curved(exported(mesh), path, extension.substr(1));
}

}  // namespace mq::curve
