// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// Marks the nodes outside: the nodes covered by a ball that rolls in from far away, and pockets behind these nodes.
///
/// The ball's centre moves along edges between free nodes. Their ends are at least its radius from the input, and no
/// edge is longer than a side, so all points of an edge are at least radius - side / 2 away: no centre passes an
/// opening narrower than twice that. The empty balls around these centres are covered. This is the morphological
/// closing of the input by a ball, up to the distances between the centres.
///
/// An uncovered region is a pocket if no path into it is longer than `pocket`, as beside a face and in a concave edge;
/// it is outside, too. A deeper region is a gap, and stays closed.
/// @param pocket  mm: largest depth of a pocket
/// @throws Cancelled
void roll_ball(NodeStates& states, double pocket, Progress& progress);

}  // namespace mq::wrap
