// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Takes spikes off faces: places where a border runs along one edge and back along another, no farther apart than
/// their tolerances or `topology.detail`. The longer edge is divided where the shorter one ends (Topology::parts_of);
/// the piece beside the shorter one is joined with it, and bounds the two faces on their other sides.
/// `topology.faults` names the faces. Spikes stay where a corner would be left that is narrower than theirs and than
/// DetailCorners::kLeast, or where the other faces lie on each other. To be called after sew_collapsed_pieces, and
/// before it again: what is left of a face can be as thin.
/// @return whether there were any
/// @throws Cancelled
bool remove_spikes(Topology& topology, ShapeMap& live, const Progress* progress);

}  // namespace mq::geometry
