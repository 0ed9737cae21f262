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

/// Elements: name, number, property and nodes, eight fields a line.
void append_elements(Output& out, const NumberedElements& block, const Properties& properties) {
    const Elements& elements = *block.elements;
    const std::string_view name = elements.type->nastran;
    const std::vector<std::size_t> places = places_of(elements.type->orders.levels, elements.type->nodes);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        out += name;
        out.append(kSmall - name.size(), ' ');
        append_column(out, static_cast<long long>(block.first + k), kSmall);
        append_column(out, static_cast<long long>(properties.of(elements, k)), kSmall);
        std::size_t field = 2;
        for (const std::size_t place : places) {
            if (field == 8) {
                out += "+\n+       ";  // programs that go by columns look for the mark at the end, too
                field = 0;
            }
            append_column(out, static_cast<long long>(elements.of(k)[place]) + 1, kSmall);
            ++field;
        }
        out += elements.type->dimension == 1 ? "0.      0.      1.\n" : "\n";  // the plane of a beam
    }
}

}  // namespace

void to_nastran(Output& out, const ExportMesh& mesh) {
    const std::vector<NumberedElements> blocks = mesh.numbered(mesh.lowest(1));
    const Properties properties(mesh, blocks);
    out += "$ MeshQuality\n";
    for (std::size_t i = 0; i < properties.names().size(); ++i) {
        out += "$ property " + std::to_string(i + 1) + ": " + properties.names()[i] + "\n";
    }
    out += "BEGIN BULK\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_grid(out, i, mesh.point(i));
    }
    for (const NumberedElements& block : blocks) {
        append_elements(out, block, properties);
    }
    out += "ENDDATA\n";
}

}  // namespace mq::mesh
