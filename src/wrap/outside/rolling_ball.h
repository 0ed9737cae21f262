// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// Marks the nodes outside: those that a ball which rolls in from far away covers, and pockets behind it.
///
/// The ball's centre moves along edges between free nodes. Their ends are at least its radius from the input, and an
/// edge is no longer than a side, so all of its points are at least radius - side / 2 away: no centre passes an opening
/// narrower than twice that. Then nodes join that lie within the ball's reach of a centre, and that edges which do not
/// meet the input lead to. This is the morphological closing of the input by a ball.
///
/// What the ball does not reach behind these nodes is a pocket where no way into it is longer than `pocket`, as in a
/// concave edge; it is outside, too. What goes on deeper is a gap, and stays closed.
/// @param reach  of a node from the ball's centre, mm, at least the radius
/// @param pocket  depth, mm
/// @throws Cancelled
void mark_outside(NodeStates& states, double reach, double pocket, const Progress& progress);

}  // namespace mq::wrap
