// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/single_precision_grid.h"
#include "geometry/session.h"

namespace mq::triangulate {

/// Returns by edge and end the radius around the node, mm, within which the edge is not told apart from the next edge
/// of a face; 0: there is no such stretch.
///
/// Two edges of a face that leave a node in nearly the same direction are not told apart where their distance from each
/// other is below their distance from their faces, or below single precision. Where modellers approximate tangent
/// curves (the chamfer of a nut, the run-out of a thread) these cross there at will: vertices there would make
/// triangles that fold, or edges that shrink without end. A single triangle spans the stretch instead. Up to
/// DetailCorners::kReach details from a node at which details were joined or contracted, edges are not told apart
/// either, if they enclose DetailCorners::kLeast at that distance: a fillet that was tangent to one edge then leaves
/// the other edge in its direction, too.
/// @param lengths  of the edges, mm; 0 for those that are a point
std::vector<std::array<double, 2>> unresolved_ends(geometry::Session& session, const SinglePrecisionGrid& grid,
                                                   const std::vector<double>& lengths);

}  // namespace mq::triangulate
