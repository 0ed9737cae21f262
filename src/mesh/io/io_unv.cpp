// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <charconv>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

// Widths of columns, and how many numbers of them a line has.
constexpr std::size_t kColumn = 10;
constexpr std::size_t kPerLine = 8;
constexpr std::size_t kRealColumn = 25;

void append_row(Output& out, std::initializer_list<long long> values) {
    for (const long long value : values) {
        append_column(out, value, kColumn);
    }
    out += '\n';
}

void append_real(Output& out, double value) {
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 16).ptr;
    const auto length = static_cast<std::size_t>(end - text.data());
    *std::find(text.data(), end, 'e') = 'E';
    out.append(kRealColumn - length, ' ');
    out.append(text.data(), length);
}

void begin(Output& out, const char* dataset) {
    out += "    -1\n  " + std::string(dataset) + "\n";
}

void end(Output& out) {
    out += "    -1\n";
}

/// Dataset 2411: nodes.
void append_nodes_2411(Output& out, const ExportMesh& mesh) {
    constexpr long long kColour = 11;
    begin(out, "2411");
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_row(out, {static_cast<long long>(i) + 1, 1, 1, kColour});
        const Vec3 p = mesh.point(i);
        for (int axis = 0; axis < 3; ++axis) {
            append_real(out, p[axis]);
        }
        out += '\n';
    }
    end(out);
}

/// The order of an element's nodes in the file: nodes of order 2 are listed around the element, between the corners.
std::vector<std::size_t> node_order(int dimension, int order) {
    if (dimension == 2) {
        return order == 1 ? std::vector<std::size_t>{0, 1, 2} : std::vector<std::size_t>{0, 3, 1, 4, 2, 5};
    }
    return order == 1 ? std::vector<std::size_t>{0, 1, 2, 3} : std::vector<std::size_t>{0, 4, 1, 5, 2, 6, 7, 9, 8, 3};
}

/// Elements of dataset 2412, numbered from `first` on.
void append_elements(Output& out, const ExportMesh& mesh, int dimension, std::size_t first, std::size_t property) {
    // I-DEAS' numbers of thin shell triangles and of solid tetrahedra, by order.
    constexpr long long kTypes[2][2] = {{91, 92}, {111, 118}};
    constexpr long long kColour = 7;
    const Elements& elements = mesh.elements[static_cast<std::size_t>(dimension)];
    const std::vector<std::size_t> order = node_order(dimension, mesh.order);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const auto group = static_cast<long long>(property) + elements.group[k];
        append_row(out, {static_cast<long long>(first + k), kTypes[dimension - 2][mesh.order - 1], group, 1, kColour,
                         static_cast<long long>(elements.width)});
        for (std::size_t i = 0; i < elements.width; ++i) {
            append_column(out, static_cast<long long>(elements.of(k)[order[i]]) + 1, kColumn);
            out += (i + 1) % kPerLine == 0 || i + 1 == elements.width ? "\n" : "";
        }
    }
}

/// A group of dataset 2467: its elements, then its nodes.
void append_group(Output& out, std::size_t number, const std::string& name, const std::vector<std::int32_t>& elements,
                  std::size_t first, const std::vector<std::int32_t>& nodes) {
    constexpr long long kNode = 7, kElement = 8;
    append_row(out, {static_cast<long long>(number), 0, 0, 0, 0, 0, 0,
                     static_cast<long long>(elements.size() + nodes.size())});
    out += name + "\n";
    std::size_t count = 0;
    const auto append = [&](long long kind, long long tag) {
        for (const long long value : {kind, tag, 0LL, 0LL}) {
            append_column(out, value, kColumn);
        }
        out += ++count % 2 == 0 ? "\n" : "";
    };
    for (const std::int32_t k : elements) {
        append(kElement, static_cast<long long>(first) + k);
    }
    for (const std::int32_t v : nodes) {
        append(kNode, static_cast<long long>(v) + 1);
    }
    out += count % 2 == 0 ? "" : "\n";
}

}  // namespace

void to_unv(Output& out, const ExportMesh& mesh) {
    append_nodes_2411(out, mesh);
    const std::size_t patches = mesh.patches().size();
    const std::size_t first_tetrahedron = mesh.triangles().size() + 1;
    begin(out, "2412");
    append_elements(out, mesh, 2, 1, 1);
    append_elements(out, mesh, 3, first_tetrahedron, patches + 1);
    end(out);
    begin(out, "2467");
    const auto nodes = mesh.nodes_by_patch();
    const auto triangles = mesh.triangles().by_group(patches);
    for (std::size_t p = 0; p < patches; ++p) {
        append_group(out, p + 1, mesh.patches()[p].name, triangles[p], 1, nodes[p]);
    }
    const auto solids = mesh.tetrahedra().by_group(mesh.groups[3].size());
    for (std::size_t s = 0; s < solids.size(); ++s) {
        append_group(out, patches + s + 1, mesh.groups[3][s].name, solids[s], first_tetrahedron, {});
    }
    end(out);
}

}  // namespace mq::mesh
