// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cstdio>

#include "base/error.h"
#include "curve/bezier/node_orders.h"
#include "curve/output/curved_mesh.h"
#include "mesh/io/io.h"

namespace mq::curve {

namespace {

/// VTK's number of the elements. Orders 1 and 2 have cells of their own, which more programs can read than Lagrange
/// cells, FreeCAD's FEM among them.
int cell_type(int dimension, int order) {
    // VTK's cell types of triangles and tetrahedra, by order; the last are Lagrange cells.
    constexpr int kTypes[2][3] = {{5, 22, 69}, {10, 24, 71}};
    return kTypes[dimension - 2][std::min(order, 3) - 1];
}

std::string joined(const std::vector<std::int32_t>& values) {
    std::string out;
    for (const std::int32_t value : values) {
        out += std::to_string(value) + "\n";
    }
    return out;
}

std::string data_array(const char* type, const char* name, const std::string& values) {
    return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" format=\"ascii\">\n" + values +
           "</DataArray>\n";
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

std::string points_of(const mesh::ExportMesh& mesh) {
    std::string values;
    char line[96];
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec3 p = mesh.point(i);
        std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p.x(), p.y(), p.z());
        values += line;
    }
    return "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n" + values +
           "</DataArray>\n</Points>\n";
}

}  // namespace

std::string curved_vtu(const mesh::ExportMesh& mesh) {
    const bool volume = mesh.tetrahedra().size() > 0;
    const Lattice& lattice = Lattice::of(volume ? 3 : 2, mesh.order);
    const mesh::Elements& elements = volume ? mesh.tetrahedra() : mesh.triangles();
    const std::vector<std::int32_t> nodes = reordered(elements.nodes, lattice);
    const std::vector<std::int32_t>& entity = elements.entity;
    std::vector<std::int32_t> offsets;
    for (std::size_t i = 1; i <= entity.size(); ++i) {
        offsets.push_back(static_cast<std::int32_t>(i) * lattice.size());
    }
    const std::vector<std::int32_t> types(entity.size(), cell_type(volume ? 3 : 2, mesh.order));
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" byte_order=\"LittleEndian\">\n"
           "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
           std::to_string(mesh.nodes.size()) + "\" NumberOfCells=\"" + std::to_string(entity.size()) + "\">\n" +
           "<CellData>\n" + data_array("Int32", volume ? "cad_solid" : "cad_face", joined(entity)) +
           (mesh.patches_given && !volume ? data_array("Int32", "patch", joined(elements.group)) : "") +
           "</CellData>\n" + points_of(mesh) + "<Cells>\n" + data_array("Int32", "connectivity", joined(nodes)) +
           data_array("Int32", "offsets", joined(offsets)) + data_array("UInt8", "types", joined(types)) +
           "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

void write_curved(const mesh::ExportMesh& mesh, const std::string& path, const std::string& format) {
    if (format == "msh" || format == "vtu") {
        mesh::save(path, format == "msh" ? curved_msh(mesh) : curved_vtu(mesh));
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
