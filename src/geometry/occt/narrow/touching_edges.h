// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Makes one edge of two where a solid touches itself along an edge: two edges of one solid that lie on each other
/// within their tolerances, each between two other faces. Modellers write both ways of saying that, one edge between
/// four faces and two edges; triangles of the latter would touch without having vertices in common.
///
/// Edges whose faces lie on each other there stay as they are, as do edges with a face in common. `topology.faults`
/// names the edges. The shape itself does not change.
/// @throws Cancelled
void join_touching_edges(Topology& topology, ShapeMap& live, const Progress* progress);

}  // namespace mq::geometry
