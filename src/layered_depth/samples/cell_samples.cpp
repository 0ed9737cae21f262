// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/cell_samples.h"

#include <algorithm>

namespace mq::layered_depth {

namespace {

/// The nodes and edges of one side of a cell; nodes in the order (0, 0), (1, 0), (0, 1), (1, 1).
struct CellFace {
    std::array<int, 4> nodes;
    std::array<std::array<int, 2>, 4> edges_at;  // the two edges of the face at each of its nodes
};

CellFace face_of(int axis, int side) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    CellFace face{};
    for (int corner = 0; corner < 4; ++corner) {
        const int on_u = corner & 1, on_v = corner >> 1;
        face.nodes[corner] = side << axis | on_u << u | on_v << v;
        // An edge along u has its sides on v and axis, one along v on axis and u.
        face.edges_at[corner] = {4 * u + (on_v | side << 1), 4 * v + (side | on_u << 1)};
    }
    return face;
}

std::array<CellFace, 6> make_faces() {
    std::array<CellFace, 6> faces{};
    for (int k = 0; k < 6; ++k) {
        faces[k] = face_of(k / 2, k % 2);
    }
    return faces;
}

const std::array<CellFace, 6>& faces() {
    static const std::array<CellFace, 6> all = make_faces();
    return all;
}

bool is_inside(std::uint8_t nodes, int node) {
    return (nodes >> node & 1) != 0;
}

}  // namespace

CellSheets find_sheets(std::uint8_t nodes, std::uint8_t flipped) {
    std::array<std::uint8_t, kCellEdges> label{};
    label.fill(CellSheets::kNoSheet);
    const auto join = [&](int e, int f) {
        for (const int edge : {e, f}) {
            label[edge] = label[edge] == CellSheets::kNoSheet ? static_cast<std::uint8_t>(edge) : label[edge];
        }
        const std::uint8_t from = std::max(label[e], label[f]), to = std::min(label[e], label[f]);
        std::replace(label.begin(), label.end(), from, to);
    };
    for (int f = 0; f < 6; ++f) {
        const CellFace& face = faces()[f];
        const bool part_inside = (flipped >> f & 1) == 0;
        std::array<bool, 4> in{};
        int count = 0;
        for (int k = 0; k < 4; ++k) {
            in[k] = is_inside(nodes, face.nodes[k]);
            count += in[k] ? 1 : 0;
        }
        const bool side_by_side = count == 2 && in[0] != in[3];
        for (int k = 0; k < 4; ++k) {
            // A node whose two neighbours have the other sign is cut off; on a face with alternating signs only two
            // nodes are.
            const bool cut_off = count == 1   ? in[k]
                                 : count == 3 ? !in[k]
                                              : count == 2 && !side_by_side && in[k] == part_inside;
            if (cut_off) {
                join(face.edges_at[k][0], face.edges_at[k][1]);
            }
        }
        if (side_by_side) {
            // The two edges with a sign change are opposite to each other.
            const int along = in[0] == in[1] ? 1 : 0;
            join(face.edges_at[0][along], face.edges_at[3][along]);
        }
    }
    CellSheets sheets;
    std::array<std::uint8_t, kCellEdges> number{};
    for (int e = 0; e < kCellEdges; ++e) {
        if (label[e] == e) {
            number[e] = sheets.count++;
        }
        sheets.of_edge[e] = label[e] == CellSheets::kNoSheet ? CellSheets::kNoSheet : number[label[e]];
    }
    return sheets;
}

std::uint8_t knotted_faces(std::uint8_t nodes) {
    unsigned knotted = 0;
    const CellSheets sheets = find_sheets(nodes);
    for (int f = 0; f < 6; ++f) {
        const CellFace& face = faces()[f];
        const auto in = [&](int k) { return is_inside(nodes, face.nodes[k]); };
        const bool checkered = in(0) == in(3) && in(1) == in(2) && in(0) != in(1);
        if (checkered && sheets.of_edge[face.edges_at[0][0]] == sheets.of_edge[face.edges_at[3][0]]) {
            knotted |= 1U << f;
        }
    }
    return static_cast<std::uint8_t>(knotted);
}

CellCensus census(const CellBox& box, const CellSample* first, const CellSample* last) {
    CellCensus result;
    std::array<std::uint8_t, kCellEdges> on_edge{};
    for (const CellSample* s = first; s != last; ++s) {
        ++(s->reconstructed != 0 ? result.reconstructed : result.retained);
        for (int k = 1; k <= 2; ++k) {
            const int axis = (s->axis + k) % 3;
            const int offset = s->at[axis] - box.low[axis];
            if (offset == 0 || offset == box.size) {
                result.faces_hit |= static_cast<std::uint8_t>(1 << (2 * axis + (offset == 0 ? 0 : 1)));
            }
        }
        const int edge = edge_of(box, *s);
        if (edge >= 0 && ++on_edge[edge] > 1) {
            result.crowded_edge = true;
        }
    }
    return result;
}

bool simple_topology(std::uint8_t nodes, const CellCensus& samples) {
    if (samples.crowded_edge || nodes == 0 || nodes == 255) {
        return false;  // fake solid or empty volume: there are samples
    }
    for (int k = 0; k < 6; ++k) {
        std::array<bool, 4> in{};
        for (int i = 0; i < 4; ++i) {
            in[i] = is_inside(nodes, faces()[k].nodes[i]);
        }
        const bool ambiguous = in[0] == in[3] && in[1] == in[2] && in[0] != in[1];
        const bool even = in[0] == in[1] && in[1] == in[2] && in[2] == in[3];
        const bool fake = even && (samples.faces_hit >> k & 1) != 0;
        if (ambiguous || fake) {
            return false;
        }
    }
    for (int k = 0; k < 4; ++k) {
        const auto diagonal = static_cast<std::uint8_t>(1 << k | 1 << (7 - k));
        if (nodes == diagonal || nodes == static_cast<std::uint8_t>(~diagonal)) {
            return false;  // voxel ambiguous
        }
    }
    return true;
}

}  // namespace mq::layered_depth
