// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Removes spikes of faces: places in which a border runs along one edge and back along another, no farther apart than
/// their tolerances or `topology.detail`. The longer edge is divided at the end of the shorter one
/// (Topology::parts_of); the piece beside the shorter edge is joined with it, and bounds the two faces on their other
/// sides. `topology.faults` names the faces. A spike stays if its removal would leave a corner that is narrower than
/// its own and than DetailCorners::kLeastAngle, or if the other faces lie on each other.
///
/// Makes one edge of two neighbours that cross on the face beside their node and within their tolerance, or coincide
/// there, up to where they have left each other by that. `topology.faults` names them, too. Call it after
/// remove_degenerate_faces, and call that again afterwards: the remainder of a face can be as thin.
/// @return whether there were any
/// @throws Cancelled
bool remove_spikes(Topology& topology, ShapeMap& live, const Progress* progress);

}  // namespace mq::geometry
