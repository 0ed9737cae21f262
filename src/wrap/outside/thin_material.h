// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/progress.h"
#include "wrap/lattice/node_states.h"

namespace mq::wrap {

/// Moves nodes into material through which edges between two nodes outside pass: edges and corners with a thin tip,
/// thin walls. The moved nodes are no longer outside.
///
/// A node moves to the middle of the material on such an edge, if that is at most half a side away, no tetrahedron at
/// the node becomes flat (kFlatCell), and all edges to nodes outside meet the input after the move. The tetrahedra
/// still fill space without overlap, so that all properties of the lattice hold (compare the warping of Labelle and
/// Shewchuk 2007).
/// @throws Cancelled
void move_into_thin_material(NodeStates& states, Progress& progress);

/// Marks nodes beside material that still lies between nodes outside as sheets; they are no longer outside. If an edge
/// between two nodes outside meets the input, one of them is at most half a side from it: that node becomes a sheet.
/// Then no edge between nodes outside meets the input. @return the number of marked nodes.
/// @throws Cancelled
std::size_t mark_sheets(NodeStates& states, Progress& progress);

}  // namespace mq::wrap
