// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::layered_depth {

/// The Node-Open operator (Wang 2010, Fig. 12). A point whose triangles form more than one fan is duplicated, one copy
/// for each fan, so that each border point has two border edges and each inner point one closed fan. No directed edge
/// may be used twice.
///
/// @param points copies are appended
/// @param triangles is rewritten; must hold all triangles around the points marked in `candidate`
/// @param candidate which points are examined
/// @return for each new point the point that it is a copy of
std::vector<std::int32_t> open_nodes(std::vector<Vec3>& points, std::vector<mesh::Triangle>& triangles,
                                     const std::vector<std::uint8_t>& candidate);

/// Separates duplicated points, so that the sheets do not touch: each copy moves towards the middle of its neighbours
/// by `distance`, or by a tenth of the way if that is less. Points of triangles with a source (not negative) stay.
/// @param originals see open_nodes; the copies are the points from `first_copy` on
void separate_nodes(std::vector<Vec3>& points, const std::vector<mesh::Triangle>& triangles,
                    const std::vector<std::int32_t>& source, const std::vector<std::int32_t>& originals,
                    std::int32_t first_copy, double distance);

/// The holes of a surface: closed loops over its border points, against the direction of the triangles beside them,
/// that is, in the direction of the triangles that would fill them. Each border point must have two border edges. Edges
/// between two points that are not in `candidate` are ignored.
std::vector<std::vector<std::int32_t>> find_holes(const std::vector<mesh::Triangle>& triangles,
                                                  const std::vector<std::uint8_t>& candidate);

/// Removes pairs of triangles with the same corners, back to back: closed surfaces without volume. Contouring makes
/// some in cells that contain thin walls, and filling the hole around a triangle without neighbours makes its reverse
/// side.
/// @param triangles  no directed edge may be used twice; only triangles with all corners in `candidate` are examined
/// @param source     loses the same entries as the triangles
/// @return the former indices of the removed triangles, ascending
std::vector<std::size_t> drop_opposite_duplicates(std::vector<mesh::Triangle>& triangles,
                                                  std::vector<std::int32_t>& source,
                                                  const std::vector<std::uint8_t>& candidate);

}  // namespace mq::layered_depth
