// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/face_triangulation.h"

namespace mq::geometry {

/// Adds the triangles and their links to a triangulation that has their sites. Those with a side that is one vertex in
/// space (at a pole) vanish; their two other sides become one.
/// @return the borders that would become one: the face closes on itself there, and nothing is added
std::optional<std::array<int, 2>> add_but_collapsed(const std::vector<std::array<int, 3>>& triangles,
                                                    std::vector<std::array<FaceTriangulation::Link, 3>> links,
                                                    FaceTriangulation& result);

}  // namespace mq::geometry
