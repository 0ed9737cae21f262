// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// Marks the nodes outside: those that a ball which rolls in from far away covers, and pockets behind it.
///
/// The ball's centre moves along edges between free nodes. Their ends are at least its radius from the input, and an
/// edge is no longer than a side, so all of its points are at least radius - side / 2 away: no centre passes an opening
/// narrower than twice that. Covered are the empty balls around these centres. This is the morphological closing of the
/// input by a ball, but for what is between the centres.
///
/// What is left behind them is a pocket where no way into it is longer than `pocket`, as beside a face and in a concave
/// edge; it is outside, too. What goes on deeper is a gap, and stays closed.
/// @param pocket  depth, mm
/// @throws Cancelled
void mark_outside(NodeStates& states, double pocket, Progress& progress);

}  // namespace mq::wrap
