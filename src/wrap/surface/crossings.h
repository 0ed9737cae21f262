// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "contour/crossing.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// All tetrahedra that the wrap crosses, with the crossings of their edges. On an edge that meets the input the
/// crossing is the first common point, seen from outside; at a sheet it is half a side before that; on an edge that
/// closes a gap it is on the ball that covers the outer end.
/// @throws Cancelled
contour::CrossedCells find_crossings(const NodeStates& states, Progress& progress);

}  // namespace mq::wrap
