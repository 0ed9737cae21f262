// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <charconv>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

template <typename T>
void append_chars(std::string& out, T value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    out.append(buffer.data(), end);
}

}  // namespace

void append_number(std::string& out, double value) {
    append_chars(out, value);
}
void append_number(std::string& out, float value) {
    append_chars(out, value);
}
void append_number(std::string& out, long long value) {
    append_chars(out, value);
}

void append_point_text(std::string& out, const Vec3& p) {
    for (int i = 0; i < 3; ++i) {
        append_number(out, p[i]);
        out += i < 2 ? ' ' : '\n';
    }
}

void append_nodes(std::string& out, const std::int32_t* nodes, std::size_t count, int first, char separator) {
    for (std::size_t i = 0; i < count; ++i) {
        out += separator;
        append_number(out, static_cast<long long>(nodes[i]) + first);
    }
    out += '\n';
}

void append_column(std::string& out, long long value, std::size_t width) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    const auto length = static_cast<std::size_t>(end - digits.data());
    out.append(width > length ? width - length : 0, ' ');
    out.append(digits.data(), end);
}

namespace {

void append_faces(std::string& out, const ExportMesh& mesh) {
    const Elements& triangles = mesh.triangles();
    std::int32_t face = -1;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (!triangles.entity.empty() && triangles.entity[k] != face) {
            face = triangles.entity[k];
            out += "g Face" + std::to_string(face + 1) + "\n";
        }
        out += 'f';
        append_nodes(out, triangles.of(k), 3, 1);
    }
}

void append_patches(std::string& out, const ExportMesh& mesh) {
    const auto patches = mesh.triangles().by_group(mesh.patches().size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
        out += "g " + mesh.patches()[p].name + "\n";
        for (const std::int32_t k : patches[p]) {
            out += 'f';
            append_nodes(out, mesh.triangles().of(static_cast<std::size_t>(k)), 3, 1);
        }
    }
}

}  // namespace

std::string to_obj(const ExportMesh& mesh) {
    std::string out = "# MeshQuality\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        out += "v ";
        append_point_text(out, mesh.point(i));
    }
    if (mesh.patches_given) {
        append_patches(out, mesh);
    } else {
        append_faces(out, mesh);
    }
    return out;
}

std::string to_off(const ExportMesh& mesh) {
    std::string out =
        "OFF\n" + std::to_string(mesh.nodes.size()) + " " + std::to_string(mesh.triangles().size()) + " 0\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_point_text(out, mesh.point(i));
    }
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        out += '3';
        append_nodes(out, mesh.triangles().of(k), 3, 0);
    }
    return out;
}

std::string to_tri(const ExportMesh& mesh) {
    const Elements& triangles = mesh.triangles();
    std::string out = std::to_string(mesh.nodes.size()) + " " + std::to_string(triangles.size()) + "\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_point_text(out, mesh.point(i));
    }
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const std::int32_t* t = triangles.of(k);
        for (std::size_t i = 0; i < 3; ++i) {
            append_number(out, static_cast<long long>(t[i]) + 1);
            out += i < 2 ? ' ' : '\n';
        }
    }
    for (const std::int32_t patch : triangles.group) {
        append_number(out, static_cast<long long>(patch) + 1);
        out += '\n';
    }
    return out;
}

}  // namespace mq::mesh
