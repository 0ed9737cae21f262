// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace mq::layered_depth {

/// A sample of the result as the octree stores it. On the sample's own axis `at` is the unit interval that contains it,
/// on the other two axes the coordinates of its ray.
struct CellSample {
    std::array<std::int16_t, 3> at{};
    std::uint8_t axis = 0;
    std::uint8_t reconstructed = 0;  ///< 1 for an IR-sample
    std::uint32_t index = 0;         ///< index among the combined samples of its axis
};

/// A cube of the octree in grid units.
struct CellBox {
    std::array<int, 3> low{};
    int size = 1;

    CellBox child(int octant) const {
        const int half = size / 2;
        return {{low[0] + (octant & 1) * half, low[1] + (octant >> 1 & 1) * half, low[2] + (octant >> 2 & 1) * half},
                half};
    }
};

/// An edge of a cell: 4 * axis + side on axis + 1 + 2 * side on axis + 2 (modulo 3). Nodes of a cell: x + 2 y + 4 z.
constexpr int kCellEdges = 12;

/// The edge of the cell that a sample lies on; -1 if it lies in a face or inside of the cell.
inline int edge_of(const CellBox& box, const CellSample& s) {
    int corner = 0;
    for (int k = 1; k <= 2; ++k) {
        const int axis = (s.axis + k) % 3, offset = s.at[axis] - box.low[axis];
        if (offset != 0 && offset != box.size) {
            return -1;
        }
        corner |= (offset == 0 ? 0 : 1) << (k - 1);
    }
    return 4 * s.axis + corner;
}

/// The sheets of the surface in a cell, determined by the signs of its nodes: a sheet connects edges with a sign change
/// over the cell's faces. If all four edges of a face change sign, the sheets separate its inside nodes, or its outside
/// nodes if the face is in `flipped` (bit 2 * axis + side).
struct CellSheets {
    std::uint8_t count = 0;
    std::array<std::uint8_t, kCellEdges> of_edge{};  ///< the sheet of each edge; kNoSheet without a sign change

    /// The sheet of an edge without a sign change.
    static constexpr std::uint8_t kNoSheet = 255;
};
CellSheets find_sheets(std::uint8_t nodes, std::uint8_t flipped = 0);
/// The faces whose four edges all change sign and belong to one sheet, bit 2 * axis + side. If two such cells share
/// such a face, it must be flipped for both, or four faces of the result would share an edge (Wenger 2013, section
/// 3.4).
std::uint8_t knotted_faces(std::uint8_t nodes);

/// Properties of a cell's topology that its samples show.
struct CellCensus {
    int reconstructed = 0, retained = 0;
    bool crowded_edge = false;   ///< more than one sample on one of the twelve edges
    std::uint8_t faces_hit = 0;  ///< bit 2 * axis + side: a sample lies in that face
};

CellCensus census(const CellBox& box, const CellSample* first, const CellSample* last);

/// Whether the topology that follows from the signs of a cell's eight nodes (bit set: inside) is certain, given the
/// census (Wang 2010, Fig. 4 and 5).
bool simple_topology(std::uint8_t nodes, const CellCensus& samples);

}  // namespace mq::layered_depth
