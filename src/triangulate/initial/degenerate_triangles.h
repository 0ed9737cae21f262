// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "triangulate/initial/face_triangulator.h"

namespace mq::triangulate {

/// Adds the triangles and their links to a triangulation that has their sites. Triangles with a side that is one
/// vertex in space (at a pole) are dropped, and their two other sides joined into one edge. The borders of the result
/// are known already.
/// @return the two borders that would become one edge, or twice a border that is one vertex and yet a side of a
/// triangle with three vertices: the face closes on itself there, and nothing is added
std::optional<std::array<int, 2>> add_without_degenerate(const std::vector<std::array<int, 3>>& triangles,
                                                         std::vector<std::array<FaceMesh::Link, 3>> links,
                                                         FaceMesh& result);

}  // namespace mq::triangulate
