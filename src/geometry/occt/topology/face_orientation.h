// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Turns faces that belong to no shell so that those that share an edge show the same side. A set without free edges
/// shows its outside; inside an odd number of other such sets it bounds a void, and shows the side that looks into the
/// void. Most faces of an open set, and faces that share no edge with others, stay as they are.
/// @param loose  by face: 1 for those that may be turned
/// @return the faces that were turned
/// @throws Cancelled
std::vector<int> orient_loose_faces(Topology& topology, const ShapeMap& live, const std::vector<char>& loose,
                                    const Progress* progress);

}  // namespace mq::geometry
