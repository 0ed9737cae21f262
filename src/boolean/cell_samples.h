// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace mq::boolean {

/// A sample of the result as the octree sees it. On the sample's own axis `at` is the unit interval that it lies in, on
/// the other two the coordinates of its ray.
struct CellSample {
    std::array<std::int16_t, 3> at{};
    std::uint8_t axis = 0;
    std::uint8_t reconstructed = 0;  ///< 1 for an IR-sample
    std::uint32_t index = 0;         ///< in the combined samples of its axis
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

/// What the samples in a closed cell tell about its topology.
struct CellCensus {
    int reconstructed = 0, retained = 0;
    bool crowded_edge = false;   ///< more than one sample on one of the twelve edges
    std::uint8_t faces_hit = 0;  ///< bit 2 * axis + side: a sample lies in that face
};

inline CellCensus census(const CellBox& box, const CellSample* first, const CellSample* last) {
    CellCensus result;
    std::array<std::uint8_t, 12> on_edge{};
    for (const CellSample* s = first; s != last; ++s) {
        ++(s->reconstructed != 0 ? result.reconstructed : result.retained);
        int sides = 0, corner = 0;
        for (int k = 1; k <= 2; ++k) {
            const int axis = (s->axis + k) % 3;
            const int offset = s->at[axis] - box.low[axis];
            if (offset == 0 || offset == box.size) {
                const int side = offset == 0 ? 0 : 1;
                result.faces_hit |= static_cast<std::uint8_t>(1 << (2 * axis + side));
                corner |= side << (k - 1);
                ++sides;
            }
        }
        if (sides == 2 && ++on_edge[4 * s->axis + corner] > 1) {
            result.crowded_edge = true;
        }
    }
    return result;
}

/// Signs of a cell's eight nodes, bit x + 2 y + 4 z set inside: whether the topology they show is beyond doubt, given
/// the census (Wang 2010, Fig. 4 and 5).
inline bool simple_topology(std::uint8_t nodes, const CellCensus& samples) {
    if (samples.crowded_edge || nodes == 0 || nodes == 255) {
        return false;  // fake solid and empty volumes: there are samples
    }
    const auto node = [&](int k) { return (nodes >> k & 1) != 0; };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        for (int side = 0; side < 2; ++side) {
            const int base = side << axis;
            const bool a = node(base), b = node(base | u), c = node(base | v), d = node(base | u | v);
            const bool ambiguous = a == d && b == c && a != b;
            const bool fake = a == b && b == c && c == d && (samples.faces_hit >> (2 * axis + side) & 1) != 0;
            if (ambiguous || fake) {
                return false;
            }
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

}  // namespace mq::boolean
