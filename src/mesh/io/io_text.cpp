// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <charconv>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

void append_point_text(Output& out, const Vec3& p, std::string_view end) {
    for (int i = 0; i < 3; ++i) {
        out.append_number(p[i]);
        if (i < 2) {
            out += ' ';
        }
    }
    out += end;
}

void append_nodes(Output& out, const std::int32_t* nodes, std::size_t count, int first, char separator,
                  std::string_view end) {
    for (std::size_t i = 0; i < count; ++i) {
        out += separator;
        out.append_number(static_cast<long long>(nodes[i]) + first);
    }
    out += end;
}

void append_column(Output& out, long long value, std::size_t width) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    const auto length = static_cast<std::size_t>(end - digits.data());
    out.append(width > length ? width - length : 0, ' ');
    out.append(digits.data(), length);
}

namespace {

void append_faces(Output& out, const ExportMesh& mesh) {
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

void append_patches(Output& out, const ExportMesh& mesh) {
    const auto triangles = mesh.numbered(2);
    for (const Members& patch : divided(mesh, triangles)) {
        out += "g " + patch.name + "\n";
        for (const auto& [block, k] : patch.elements) {
            out += 'f';
            append_nodes(out, mesh.triangles().of(static_cast<std::size_t>(k)), 3, 1);
        }
    }
}

}  // namespace

void to_obj(Output& out, const ExportMesh& mesh) {
    out += "# MeshQuality\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        out += "v ";
        append_point_text(out, mesh.point(i));
    }
    if (mesh.patches_given) {
        append_patches(out, mesh);
    } else {
        append_faces(out, mesh);
    }
}

void to_off(Output& out, const ExportMesh& mesh) {
    out += "OFF\n" + std::to_string(mesh.nodes.size()) + " " + std::to_string(mesh.triangles().size()) + " 0\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_point_text(out, mesh.point(i));
    }
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        out += '3';
        append_nodes(out, mesh.triangles().of(k), 3, 0);
    }
}

void to_tri(Output& out, const ExportMesh& mesh) {
    const Elements& triangles = mesh.triangles();
    out += std::to_string(mesh.nodes.size()) + " " + std::to_string(triangles.size()) + "\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_point_text(out, mesh.point(i));
    }
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const std::int32_t* t = triangles.of(k);
        for (std::size_t i = 0; i < 3; ++i) {
            out.append_number(static_cast<long long>(t[i]) + 1);
            out += i < 2 ? ' ' : '\n';
        }
    }
    for (const std::int32_t patch : triangles.group) {
        out.append_number(static_cast<long long>(patch) + 1);
        out += '\n';
    }
}

}  // namespace mq::mesh
