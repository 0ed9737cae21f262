// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

std::string base64(const std::string& bytes) {
    // The alphabet of base64.
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
        }
    }
    return out;
}

/// `bytes` holds the values; VTK needs their length in front, in the same base64 run.
std::string data_array(const std::string& attributes, const std::string& bytes) {
    std::string block;
    append_bytes(block, static_cast<std::uint64_t>(bytes.size()));
    return "<DataArray " + attributes + " format=\"binary\">" + base64(block + bytes) + "</DataArray>\n";
}

template <typename T, typename Values>
std::string bytes_of(const Values& values) {
    std::string out;
    out.reserve(values.size() * sizeof(T));
    for (const auto& value : values) {
        append_bytes(out, static_cast<T>(value));
    }
    return out;
}

std::string points_array(const ExportMesh& mesh) {
    const bool single = fits_single_precision(mesh);
    std::string bytes;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        if (single) {
            append_point<float>(bytes, mesh.point(i));
        } else {
            append_point<double>(bytes, mesh.point(i));
        }
    }
    return data_array(
        single ? "type=\"Float32\" NumberOfComponents=\"3\"" : "type=\"Float64\" NumberOfComponents=\"3\"", bytes);
}

std::string cells(const ExportMesh& mesh) {
    // VTK's cell type of a triangle.
    constexpr std::uint8_t kVtkTriangle = 5;
    const std::size_t count = mesh.triangles().size();
    std::vector<std::int32_t> offsets;
    for (std::size_t k = 1; k <= count; ++k) {
        offsets.push_back(static_cast<std::int32_t>(3 * k));
    }
    const std::vector<std::uint8_t> types(count, kVtkTriangle);
    return "<Cells>\n" +
           data_array("type=\"Int32\" Name=\"connectivity\"", bytes_of<std::int32_t>(mesh.triangles().nodes)) +
           data_array("type=\"Int32\" Name=\"offsets\"", bytes_of<std::int32_t>(offsets)) +
           data_array("type=\"UInt8\" Name=\"types\"", bytes_of<std::uint8_t>(types)) + "</Cells>\n";
}

}  // namespace

std::string to_vtu(const ExportMesh& mesh) {
    std::string out =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
        std::to_string(mesh.nodes.size()) + "\" NumberOfCells=\"" + std::to_string(mesh.triangles().size()) + "\">\n";
    if (!mesh.node_entity.empty()) {
        out += "<PointData>\n" +
               data_array("type=\"Int32\" Name=\"cad_entity\" NumberOfComponents=\"2\"",
                          bytes_of<VertexEntity>(mesh.node_entity)) +
               "</PointData>\n";
    }
    const Elements& triangles = mesh.triangles();
    if (!triangles.entity.empty() || mesh.patches_given) {
        out += "<CellData>\n";
        if (!triangles.entity.empty()) {
            out += data_array("type=\"Int32\" Name=\"cad_face\"", bytes_of<std::int32_t>(triangles.entity));
        }
        if (mesh.patches_given) {
            out += data_array("type=\"Int32\" Name=\"patch\"", bytes_of<std::int32_t>(triangles.group));
        }
        out += "</CellData>\n";
    }
    out += "<Points>\n" + points_array(mesh) + "</Points>\n" + cells(mesh);
    return out + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace mq::mesh
