// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <set>
#include <vector>

#include "geometry/topology.h"

namespace mq::triangulate {

/// Returns the edges shorter than the detail of the topology that can be contracted to one vertex, in ascending order
/// of length. A triangulation with bounded angles is graded from its shortest edge outwards: an edge far shorter than
/// the requested distance would cost a great number of triangles, and show nowhere.
///
/// An edge is left as it is where contracting it would damage a face: where its neighbours on a loop would meet at less
/// than 30 degrees, as the long sides of a thin plate, or where another edge joins the same two nodes. The nodes that
/// are contracted to one vertex lie within the detail of each other (virtual topology: Sheffer, Blacker and Bercovier
/// 1997, edge collapse).
/// @param points  of every edge's polyline, mm
/// @param lengths  of the polylines, mm; 0: the edge is a vertex already
/// @param kept  edges that are left as they are in any case
std::vector<int> contractible_edges(const geometry::Topology& topology, const std::vector<std::vector<Vec3>>& points,
                                    const std::vector<double>& lengths, const std::set<int>& kept);

}  // namespace mq::triangulate
