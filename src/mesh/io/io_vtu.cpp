// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

/// Appends the values in base64, with the length in bytes in front that VTK needs in the same run.
template <typename T>
void append_base64(Output& out, const std::vector<T>& values) {
    // The alphabet of base64.
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::uint64_t length = values.size() * sizeof(T);
    const auto* body = reinterpret_cast<const unsigned char*>(values.data());
    const auto* head = reinterpret_cast<const unsigned char*>(&length);
    const auto byte = [&](std::size_t i) { return i < sizeof length ? head[i] : body[i - sizeof length]; };
    const std::size_t size = sizeof length + length;
    for (std::size_t i = 0; i < size; i += 3) {
        const std::size_t count = std::min<std::size_t>(3, size - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (k < count ? byte(i + k) : 0u);
        }
        std::array<char, 4> text;
        for (std::size_t k = 0; k < 4; ++k) {
            text[k] = k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
        }
        out.append(text.data(), text.size());
    }
}

template <typename T>
void append_array(Output& out, const char* attributes, const std::vector<T>& values) {
    out += "<DataArray ";
    out += attributes;
    out += " format=\"binary\">";
    append_base64(out, values);
    out += "</DataArray>\n";
}

template <typename Real>
std::vector<Real> coordinates_of(const ExportMesh& mesh) {
    std::vector<Real> found;
    found.reserve(3 * mesh.nodes.size());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec3 p = mesh.point(i);
        for (int axis = 0; axis < 3; ++axis) {
            found.push_back(static_cast<Real>(p[axis]));
        }
    }
    return found;
}

void append_points(Output& out, const ExportMesh& mesh) {
    out += "<Points>\n";
    if (fits_single_precision(mesh)) {
        append_array(out, "type=\"Float32\" NumberOfComponents=\"3\"", coordinates_of<float>(mesh));
    } else {
        append_array(out, "type=\"Float64\" NumberOfComponents=\"3\"", coordinates_of<double>(mesh));
    }
    out += "</Points>\n";
}

/// Nodes of all cells, one after the other, in VTK's order.
std::vector<std::int32_t> connectivity_of(const std::vector<NumberedElements>& blocks) {
    std::vector<std::int32_t> found;
    for (const auto& [block, first] : blocks) {
        const std::vector<std::size_t> places =
            block->type->order > 2 ? block->lagrange : places_of(block->type->orders.rings, block->type->nodes);
        for (std::size_t k = 0; k < block->size(); ++k) {
            for (const std::size_t place : places) {
                found.push_back(block->of(k)[place]);
            }
        }
    }
    return found;
}

template <typename Integer>
std::vector<Integer> offsets_of(const std::vector<NumberedElements>& blocks) {
    std::vector<Integer> found;
    Integer last = 0;
    for (const auto& [block, first] : blocks) {
        for (std::size_t k = 0; k < block->size(); ++k) {
            found.push_back(last += static_cast<Integer>(block->type->nodes));
        }
    }
    return found;
}

void append_cells(Output& out, const std::vector<NumberedElements>& blocks) {
    const std::vector<std::int32_t> nodes = connectivity_of(blocks);
    std::vector<std::uint8_t> types;
    for (const auto& [block, first] : blocks) {
        types.insert(types.end(), block->size(), static_cast<std::uint8_t>(block->type->vtk));
    }
    out += "<Cells>\n";
    append_array(out, "type=\"Int32\" Name=\"connectivity\"", nodes);
    if (nodes.size() <= std::numeric_limits<std::int32_t>::max()) {
        append_array(out, "type=\"Int32\" Name=\"offsets\"", offsets_of<std::int32_t>(blocks));
    } else {
        append_array(out, "type=\"Int64\" Name=\"offsets\"", offsets_of<std::int64_t>(blocks));
    }
    append_array(out, "type=\"UInt8\" Name=\"types\"", types);
    out += "</Cells>\n";
}

/// The CAD entity of each cell, and its patch if patches were given; for the mesh of another program its first group.
void append_cell_data(Output& out, const ExportMesh& mesh, const std::vector<NumberedElements>& blocks) {
    std::vector<std::int32_t> entities, groups;
    for (const auto& [block, first] : blocks) {
        entities.insert(entities.end(), block->entity.begin(), block->entity.end());
        for (std::size_t k = 0; k < block->size(); ++k) {
            groups.push_back(mesh.first_group(*block, k));
        }
    }
    const bool solid = mesh.dimension() == 3;
    const bool has_patch = mesh.patches_given && !solid;
    if (mesh.is_given()) {
        out += "<CellData>\n";
        append_array(out, "type=\"Int32\" Name=\"group\"", groups);
        out += "</CellData>\n";
    } else if (!entities.empty() || has_patch) {
        out += "<CellData>\n";
        if (!entities.empty()) {
            append_array(out, solid ? "type=\"Int32\" Name=\"cad_solid\"" : "type=\"Int32\" Name=\"cad_face\"",
                         entities);
        }
        if (has_patch) {
            append_array(out, "type=\"Int32\" Name=\"patch\"", groups);
        }
        out += "</CellData>\n";
    }
}

}  // namespace

// Writes the cells of the highest dimension; for the mesh of another program all cells. Orders of nodes are those of
// version 2.2.
void to_vtu(Output& out, const ExportMesh& mesh) {
    const std::vector<NumberedElements> blocks = mesh.numbered(mesh.is_given() ? 1 : mesh.dimension());
    out += std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"") +
           (mesh.order() == 1 ? "1.0" : "2.2") +
           "\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    for (std::size_t g = 0; g < mesh.patches().size() && mesh.is_given(); ++g) {
        out += "<!-- group " + std::to_string(g) + ": ";
        char last = ' ';
        for (const char c : mesh.patches()[g].name) {
            out += c == '-' && last == '-' ? " -" : std::string(1, c);  // no comment has two in a row
            last = c;
        }
        out += " -->\n";
    }
    out += "<Piece NumberOfPoints=\"" + std::to_string(mesh.nodes.size()) + "\" NumberOfCells=\"" +
           std::to_string(count_of(blocks)) + "\">\n";
    if (!mesh.node_entity.empty()) {
        out += "<PointData>\n";
        append_array(out, "type=\"Int32\" Name=\"cad_entity\" NumberOfComponents=\"2\"", mesh.node_entity);
        out += "</PointData>\n";
    }
    append_cell_data(out, mesh, blocks);
    append_points(out, mesh);
    append_cells(out, blocks);
    out += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace mq::mesh
