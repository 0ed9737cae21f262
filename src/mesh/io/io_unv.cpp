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

/// Elements of dataset 2412.
void append_elements(Output& out, const NumberedElements& block, const Properties& properties) {
    constexpr long long kColour = 7;
    const Elements& elements = *block.elements;
    const std::vector<std::size_t> places = places_of(elements.type->orders.around, elements.type->nodes);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        append_row(out, {static_cast<long long>(block.first + k), elements.type->unv,
                         static_cast<long long>(properties.of(elements, k)), 1, kColour,
                         static_cast<long long>(places.size())});
        if (elements.type->dimension == 1) {
            append_row(out, {0, 1, 1});  // the cross-section of a beam and where it lies
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            append_column(out, static_cast<long long>(elements.of(k)[places[i]]) + 1, kColumn);
            out += (i + 1) % kPerLine == 0 || i + 1 == places.size() ? "\n" : "";
        }
    }
}

/// A group of dataset 2467: its elements, then its nodes.
void append_group(Output& out, std::size_t number, const Members& group) {
    constexpr long long kNode = 7, kElement = 8;
    append_row(out, {static_cast<long long>(number), 0, 0, 0, 0, 0, 0,
                     static_cast<long long>(group.elements.size() + group.nodes.size())});
    out += group.name + "\n";
    std::size_t count = 0;
    const auto append = [&](long long kind, long long tag) {
        for (const long long value : {kind, tag, 0LL, 0LL}) {
            append_column(out, value, kColumn);
        }
        out += ++count % 2 == 0 ? "\n" : "";
    };
    for (const auto& [block, k] : group.elements) {
        append(kElement, static_cast<long long>(block->first) + k);
    }
    for (const std::int32_t v : group.nodes) {
        append(kNode, static_cast<long long>(v) + 1);
    }
    out += count % 2 == 0 ? "" : "\n";
}

}  // namespace

void to_unv(Output& out, const ExportMesh& mesh) {
    const std::vector<NumberedElements> blocks = mesh.numbered(mesh.lowest(2));
    const Properties properties(mesh, blocks);
    append_nodes_2411(out, mesh);
    begin(out, "2412");
    for (const NumberedElements& block : blocks) {
        append_elements(out, block, properties);
    }
    end(out);
    const std::vector<Members> groups = members_of(mesh, blocks);
    if (!groups.empty()) {
        begin(out, "2467");
        for (std::size_t g = 0; g < groups.size(); ++g) {
            append_group(out, g + 1, groups[g]);
        }
        end(out);
    }
}

}  // namespace mq::mesh
