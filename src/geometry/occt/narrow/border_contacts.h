// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Gives the border of a face a node where two edges come nearer to each other than `topology.detail` across the face,
/// as at a hole that nearly touches the outer edge, or touches it without a common vertex: both edges are divided
/// there, or end there. The face is pinched in the node then, and has narrow corners on both sides of it, which
/// cut_narrow_corners cuts off: no triangle has to fit between the edges.
///
/// Edges with a common node are in contact only beyond a place where they are a detail apart, and edges that do not
/// open to a detail on both sides of the contact are left to remove_degenerate_faces. No point moves by more than
/// the detail: a new node lies half-way in the gap, a node of one edge may be off the other one. `topology.faults`
/// names the edges. New nodes are the last ones; the tolerance of each is its distance from the edges.
/// @throws Cancelled
void join_border_contacts(Topology& topology, ShapeMap& live, const Progress* progress);

}  // namespace mq::geometry
