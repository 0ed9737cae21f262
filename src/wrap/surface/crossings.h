// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "contour/crossing.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// All tetrahedra that the wrap crosses, and where. An edge that meets the input is crossed where it does first, seen
/// from outside; at a sheet half a side before it; and where a gap is closed on the ball that covers its outer end.
/// @throws Cancelled
contour::CrossedCells find_crossings(const NodeStates& states, Progress& progress);

}  // namespace mq::wrap
