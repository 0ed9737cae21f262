// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/arrangement/arrangement.h"

namespace mq::boolean {

/// The volumes into which the faces of an arrangement divide space, and how often each operand winds around them (Zhou
/// et al. 2016, section 4; the normal index of Wang 2010, section V.C, is the same number along a ray).
struct Cells {
    int operands = 0;
    std::vector<std::int32_t> front;  ///< for each face the cell on the side to which its normal points
    std::vector<std::int32_t> back;
    std::vector<std::int32_t> winding;  ///< for each cell the windings of all operands, one after the other
    const std::int32_t* windings(std::int32_t cell) const {
        return winding.data() + static_cast<std::size_t>(cell) * static_cast<std::size_t>(operands);
    }
    std::size_t patches = 0;
    std::size_t curve_edges = 0;  ///< edges of more than two faces
};

/// @throws TopologyError when an edge has one face only, or the faces do not bound volumes
/// @throws Cancelled when `progress` says so
Cells find_cells(const Soup& soup, const Arrangement& arrangement, const Progress& progress);

}  // namespace mq::boolean
