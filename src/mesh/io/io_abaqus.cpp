// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <charconv>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

/// CalculiX reads no number of more characters.
constexpr std::size_t kLongest = 20;

/// Number of digits that always fits, whatever the sign and exponent.
constexpr int kDigits = 13;

/// Appends a number with all its digits if these fit, so that reading gives the same number; else with fewer digits.
void append_real(Output& out, double value) {
    std::array<char, 40> text;
    const auto first = text.data();
    auto last = std::to_chars(first, first + text.size(), value).ptr;
    if (static_cast<std::size_t>(last - first) > kLongest) {
        last = std::to_chars(first, first + text.size(), value, std::chars_format::general, kDigits).ptr;
    }
    out.append(first, static_cast<std::size_t>(last - first));
}

constexpr std::size_t kPerLine =
    8;  ///< numbers of a set in one line; Abaqus takes 16, and 132 characters are CalculiX's

/// Suffix of the name of a patch's sides: CalculiX 2.20 ends if a surface has the name of a set.
constexpr const char* kSurface = "_surface";

void append_set(Output& out, const std::string& head, const std::vector<std::int32_t>& numbers) {
    if (numbers.empty()) {
        return;
    }
    out += head;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        out.append_number(static_cast<long long>(numbers[i]) + 1);
        out += (i + 1) % kPerLine == 0 || i + 1 == numbers.size() ? "\n" : ", ";
    }
}

void append_element(Output& out, std::size_t id, const std::vector<std::int32_t>& nodes) {
    out.append_number(static_cast<long long>(id));
    append_nodes(out, nodes.data(), nodes.size(), 1, ',');
}

/// The side of a tetrahedron on which a triangle lies, as Abaqus numbers them, by the corner that is opposite.
int side_of(const std::int32_t* tetrahedron, const std::int32_t* triangle) {
    constexpr std::array<int, 4> kSideOpposite{3, 4, 2, 1};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        if (std::find(triangle, triangle + 3, tetrahedron[corner]) == triangle + 3) {
            return kSideOpposite[corner];
        }
    }
    return 0;
}

void append_tetrahedra(Output& out, const ExportMesh& mesh) {
    const Elements& tetrahedra = mesh.tetrahedra();
    const auto solids = tetrahedra.by_group(mesh.groups[3].size());
    for (std::size_t s = 0; s < solids.size(); ++s) {
        out += std::string("*ELEMENT, TYPE=") + (mesh.order == 1 ? "C3D4" : "C3D10") +
               ", ELSET=" + mesh.groups[3][s].name + "\n";
        for (const std::int32_t e : solids[s]) {
            std::vector<std::int32_t> nodes;
            for (std::size_t i = 0; i < tetrahedra.width; ++i) {
                nodes.push_back(tetrahedra.of(static_cast<std::size_t>(e))[kTetrahedronOrder[i]]);
            }
            append_element(out, static_cast<std::size_t>(e) + 1, nodes);
        }
    }
}

/// The sides of tetrahedra that make up each patch, for pressures and contacts, and the tetrahedra that have them.
void append_sides(Output& out, const ExportMesh& mesh) {
    const auto patches = mesh.triangles().by_group(mesh.patches().size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
        std::vector<std::int32_t> behind;  // by side, one after the other
        std::string sides;
        for (const std::int32_t k : patches[p]) {
            const auto triangle = static_cast<std::size_t>(k);
            const std::int32_t e = mesh.behind[triangle];
            if (e >= 0) {
                behind.push_back(e);
                sides += static_cast<char>(
                    '0' + side_of(mesh.tetrahedra().of(static_cast<std::size_t>(e)), mesh.triangles().of(triangle)));
            }
        }
        std::vector<std::int32_t> elements = behind;
        std::sort(elements.begin(), elements.end());
        elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
        append_set(out, "*ELSET, ELSET=" + mesh.patches()[p].name + "\n", elements);
        if (!sides.empty()) {
            out += "*SURFACE, NAME=" + mesh.patches()[p].name + kSurface + ", TYPE=ELEMENT\n";
        }
        for (std::size_t i = 0; i < sides.size(); ++i) {
            out.append_number(static_cast<long long>(behind[i]) + 1);
            out += ", S";
            out += sides[i];
            out += '\n';
        }
    }
}

void append_triangles(Output& out, const ExportMesh& mesh) {
    const Elements& triangles = mesh.triangles();
    const auto patches = triangles.by_group(mesh.patches().size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
        if (!patches[p].empty()) {
            out += std::string("*ELEMENT, TYPE=") + (mesh.order == 1 ? "S3" : "S6") +
                   ", ELSET=" + mesh.patches()[p].name + "\n";
        }
        for (const std::int32_t k : patches[p]) {
            const std::int32_t* t = triangles.of(static_cast<std::size_t>(k));
            append_element(out, static_cast<std::size_t>(k) + 1, {t, t + triangles.width});
        }
    }
}

}  // namespace

void to_abaqus(Output& out, const ExportMesh& mesh) {
    out += "*HEADING\nMeshQuality\n*NODE\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        out.append_number(static_cast<long long>(i) + 1);
        const Vec3 p = mesh.point(i);
        for (int axis = 0; axis < 3; ++axis) {
            out += ", ";
            append_real(out, p[axis]);
        }
        out += '\n';
    }
    if (mesh.tetrahedra().size() > 0) {
        append_tetrahedra(out, mesh);
    } else {
        append_triangles(out, mesh);
    }
    const auto nodes = mesh.nodes_by_patch();
    for (std::size_t p = 0; p < nodes.size(); ++p) {
        append_set(out, "*NSET, NSET=" + mesh.patches()[p].name + "\n", nodes[p]);
    }
    if (mesh.tetrahedra().size() > 0) {
        append_sides(out, mesh);
    }
}

}  // namespace mq::mesh
