// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Joins faces that belong to no shell, as those of most IGES files, along edges of theirs that bound one face each and
/// lie within `topology.detail` of each other over their whole length; nearest pairs first. Edges that lie along a
/// piece of another are joined with that piece, which becomes an edge (Topology::parts_of). Faces that lie on each
/// other beside the edge are not joined. Faces that are joined get one side (orient_loose_faces). `topology.faults`
/// says how many edges were joined, and their largest distance. The shape itself does not change.
/// @return the faces that were turned
/// @throws Cancelled
std::vector<int> join_loose_faces(Topology& topology, ShapeMap& live, const Progress* progress);

}  // namespace mq::geometry
