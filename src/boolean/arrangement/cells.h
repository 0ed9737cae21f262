// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/arrangement/arrangement.h"

namespace mq::boolean {

/// How often an operand winds around a cell.
struct Winding {
    std::int32_t operand = -1;
    std::int32_t times = 0;
    bool operator==(const Winding& other) const { return operand == other.operand && times == other.times; }
};

/// The operands that wind around a cell, ascending, none of them 0 times: of thousands only a few.
using Windings = std::vector<Winding>;

/// The volumes into which the faces of an arrangement divide space, and how often each operand winds around them (Zhou
/// et al. 2016, section 4; the normal index of Wang 2010, section V.C, is the same number along a ray).
struct Cells {
    std::vector<std::int32_t> front;  ///< for each face the cell on the side to which its normal points
    std::vector<std::int32_t> back;
    std::vector<Windings> windings;  ///< by cell
    std::size_t patches = 0;
    std::size_t curve_edges = 0;  ///< edges of more than two faces
};

/// @throws TopologyError when an edge has one face only, or the faces do not bound volumes
/// @throws Cancelled when `progress` says so
Cells find_cells(const Soup& soup, const Arrangement& arrangement, const Progress& progress);

}  // namespace mq::boolean
