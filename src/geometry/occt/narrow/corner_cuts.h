// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Cuts off the narrow corners of faces, between two edges that leave a node at less than DetailCorners::kLeastAngle,
/// where the edges are `topology.detail` apart: both are divided there, at one new node in the middle, and their pieces
/// up to the corner count as one edge. No point moves by more than half of the detail. First pieces of twice the detail
/// then enclose that angle, so that no triangle in the corner has to be below the bound.
///
/// A corner stays if the edges do not open to the detail four details before their other ends, or if the faces on their
/// other sides have a pole there, or would lie on each other beside the joined piece. `topology.faults` names the
/// corners that are cut off. The new nodes are the last ones; the tolerance of each is its distance from the edges.
/// @throws Cancelled
void cut_narrow_corners(Topology& topology, ShapeMap& live, CornerCuts kinds, const Progress* progress);

}  // namespace mq::geometry
