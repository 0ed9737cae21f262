// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/progress.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// Moves nodes into material that edges between two nodes outside pass through: tips of edges and corners, thin walls.
/// They are no longer outside.
///
/// A node goes to the middle of what such an edge has in the material, where that is at most half a side away, no
/// tetrahedron at the node becomes flat (kFlatCell), and all edges to nodes outside meet the input then. The tetrahedra
/// still divide space, so that all that is said of the lattice holds (compare the warping of Labelle and Shewchuk
/// 2007).
/// @throws Cancelled
void move_into_thin_material(NodeStates& states, Progress& progress);

/// Marks nodes at material that still lies between nodes outside as sheets; they are no longer outside. Where an edge
/// between two nodes outside meets the input, one of them is at most half a side from it: that becomes a sheet. Then no
/// edge between nodes outside meets the input. Returns the number of nodes.
/// @throws Cancelled
std::size_t mark_sheets(NodeStates& states, Progress& progress);

}  // namespace mq::wrap
