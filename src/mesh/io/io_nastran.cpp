// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <charconv>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

// Widths of the columns of a bulk data entry: small fields hold numbers of elements and nodes, large ones coordinates.
constexpr std::size_t kSmall = 8;
constexpr std::size_t kLarge = 16;

/// Appends a real number in a large field, with as many digits as it takes; Nastran wants a decimal point.
void append_real(Output& out, double value) {
    std::array<char, 40> text;
    for (int digits = 17; digits > 0; --digits) {
        const auto first = text.data();
        // With all digits, so that reading gives the same number, if these fit; else with fewer and fewer digits.
        auto last = digits == 17 ? std::to_chars(first, first + 38, value).ptr
                                 : std::to_chars(first, first + 38, value, std::chars_format::general, digits).ptr;
        if (std::find(first, last, '.') == last) {
            const auto exponent = std::find(first, last, 'e');
            std::copy_backward(exponent, last, last + 1);
            *exponent = '.';
            ++last;
        }
        const auto length = static_cast<std::size_t>(last - first);
        if (length <= kLarge) {
            out.append(kLarge - length, ' ');
            out.append(first, length);
            return;
        }
    }
}

void append_grid(Output& out, std::size_t i, const Vec3& p) {
    out += "GRID*   ";
    append_column(out, static_cast<long long>(i) + 1, kLarge);
    out.append(kLarge, ' ');  // the basic coordinate system
    append_real(out, p.x());
    append_real(out, p.y());
    out += "\n*       ";
    append_real(out, p.z());
    out += '\n';
}

/// One element: name, number, property and nodes, eight fields a line.
void append_element(Output& out, const char* name, std::size_t id, std::size_t property,
                    const std::vector<std::int32_t>& nodes) {
    out += name;
    append_column(out, static_cast<long long>(id), kSmall);
    append_column(out, static_cast<long long>(property), kSmall);
    std::size_t field = 2;
    for (const std::int32_t node : nodes) {
        if (field == 8) {
            out += "+\n+       ";  // programs that go by columns look for the mark at the end, too
            field = 0;
        }
        append_column(out, static_cast<long long>(node) + 1, kSmall);
        ++field;
    }
    out += '\n';
}

}  // namespace

void to_nastran(Output& out, const ExportMesh& mesh) {
    const Elements& triangles = mesh.triangles();
    const Elements& tetrahedra = mesh.tetrahedra();
    out += "$ MeshQuality\n";
    for (std::size_t p = 0; p < mesh.patches().size(); ++p) {
        out += "$ property " + std::to_string(p + 1) + ": patch " + mesh.patches()[p].name + "\n";
    }
    for (std::size_t s = 0; s < mesh.groups[3].size(); ++s) {
        out +=
            "$ property " + std::to_string(mesh.patches().size() + s + 1) + ": solid " + mesh.groups[3][s].name + "\n";
    }
    out += "BEGIN BULK\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_grid(out, i, mesh.point(i));
    }
    const char* triangle = mesh.order == 1 ? "CTRIA3  " : "CTRIA6  ";
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const std::int32_t* t = triangles.of(k);
        append_element(out, triangle, k + 1, static_cast<std::size_t>(triangles.group[k]) + 1,
                       {t, t + triangles.width});
    }
    for (std::size_t e = 0; e < tetrahedra.size(); ++e) {
        std::vector<std::int32_t> nodes;
        for (std::size_t i = 0; i < tetrahedra.width; ++i) {
            nodes.push_back(tetrahedra.of(e)[kTetrahedronOrder[i]]);
        }
        append_element(out, "CTETRA  ", triangles.size() + e + 1,
                       mesh.patches().size() + static_cast<std::size_t>(tetrahedra.group[e]) + 1, nodes);
    }
    out += "ENDDATA\n";
}

}  // namespace mq::mesh
