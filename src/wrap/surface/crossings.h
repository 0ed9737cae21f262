// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "contour/crossing.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// All tetrahedra of GradedCells that the wrap crosses, and where. The crossing of an edge that meets the input is the
/// meeting point nearest to its outer end; at a sheet it is half a side before that; on an edge across a gap it is
/// where the edge leaves the ball that covers the outer end.
/// @param patch  of each triangle of the input; empty: all are of one
/// @throws Cancelled
contour::CrossedCells find_crossings(const NodeStates& states, const std::vector<std::int32_t>& patch,
                                     Progress& progress);

}  // namespace mq::wrap
