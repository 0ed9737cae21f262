// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "given/matching/edge_paths.h"

namespace mq::given {

/// The CAD face of each triangle.
///
/// The mesh edges along CAD edges divide the surface into regions, each on one face: among the faces whose edges
/// include all those around a region, the one on which sampled points of the region lie.
/// @return by triangle of the graph, the index of its CAD face
/// @throws TopologyError naming the CAD vertices and edges that the mesh does not follow where a region is on no face;
/// GeometryError naming the place where triangles are on none.
std::vector<int> match_faces(geometry::Session& session, const SurfaceGraph& graph, const EdgePaths& edges);

}  // namespace mq::given
