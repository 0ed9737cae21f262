// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
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

void append_cells(Output& out, const ExportMesh& mesh) {
    // VTK's cell type of a triangle.
    constexpr std::uint8_t kVtkTriangle = 5;
    const std::size_t count = mesh.triangles().size();
    std::vector<std::int32_t> offsets;
    offsets.reserve(count);
    for (std::size_t k = 1; k <= count; ++k) {
        offsets.push_back(static_cast<std::int32_t>(3 * k));
    }
    out += "<Cells>\n";
    append_array(out, "type=\"Int32\" Name=\"connectivity\"", mesh.triangles().nodes);
    append_array(out, "type=\"Int32\" Name=\"offsets\"", offsets);
    append_array(out, "type=\"UInt8\" Name=\"types\"", std::vector<std::uint8_t>(count, kVtkTriangle));
    out += "</Cells>\n";
}

}  // namespace

void to_vtu(Output& out, const ExportMesh& mesh) {
    out +=
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
        std::to_string(mesh.nodes.size()) + "\" NumberOfCells=\"" + std::to_string(mesh.triangles().size()) + "\">\n";
    if (!mesh.node_entity.empty()) {
        out += "<PointData>\n";
        append_array(out, "type=\"Int32\" Name=\"cad_entity\" NumberOfComponents=\"2\"", mesh.node_entity);
        out += "</PointData>\n";
    }
    const Elements& triangles = mesh.triangles();
    if (!triangles.entity.empty() || mesh.patches_given) {
        out += "<CellData>\n";
        if (!triangles.entity.empty()) {
            append_array(out, "type=\"Int32\" Name=\"cad_face\"", triangles.entity);
        }
        if (mesh.patches_given) {
            append_array(out, "type=\"Int32\" Name=\"patch\"", triangles.group);
        }
        out += "</CellData>\n";
    }
    append_points(out, mesh);
    append_cells(out, mesh);
    out += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace mq::mesh
