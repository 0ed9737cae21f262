// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "base/progress.h"
#include "base/vec.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// Where the wrap crosses an edge of the lattice between a node outside and one that is not.
struct Crossing {
    Vec3 point = Vec3::Zero();     ///< on the edge, not at its ends
    Vec3 on_input = Vec3::Zero();  ///< where the edge meets the input, or comes near a sheet
    Vec3 normal = Vec3::Zero();    ///< outward, of length 1; zero where it closes a gap
    std::int32_t source = -1;      ///< the input's triangle on which it lies, or beside; -1 where it closes a gap
};

/// A tetrahedron that the wrap crosses, with the crossings of its edges as the corners of a polygon that runs
/// counter-clockwise seen from outside. Consecutive ones are on edges of one of its faces.
struct CrossedCell {
    std::array<Node, 4> nodes;
    int count = 0;  ///< 3 or 4
    std::array<std::int32_t, 4> crossings{-1, -1, -1, -1};
};

struct CrossedCells {
    std::vector<CrossedCell> cells;
    std::vector<Crossing> crossings;
};

/// All tetrahedra that the wrap crosses, and where. An edge that meets the input is crossed where it does first, seen
/// from outside; at a sheet half a side before it; and where a gap is closed on the ball that covers its outer end.
/// @throws Cancelled
CrossedCells find_crossings(const NodeStates& states, const Progress& progress);

}  // namespace mq::wrap
