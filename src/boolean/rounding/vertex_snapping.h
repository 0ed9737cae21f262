// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/progress.h"
#include "boolean/rounding/rounded_surface.h"

namespace mq::boolean {

/// Two triangles of a surface that touch or cross, the lower first.
using TrianglePair = std::array<std::int32_t, 2>;

/// The pairs that some triangles are in, ascending, each once. Triangles on the same three vertices are no pair.
/// @param triangles  alive
std::vector<TrianglePair> contacts_of(const RoundedSurface& surface, const std::vector<std::int32_t>& triangles,
                                      const Progress& progress);

/// One pass of snapping in three dimensions, after iterated snap rounding in the plane (Halperin and Packer 2002):
/// every vertex of a triangle in contact, or without area, is hot. Vertices at most `reach` (mm) from a hot one are
/// merged with it; edges and faces that pass by it within `reach` are led through it. Where edges of triangles in
/// contact pass by each other within `reach`, between vertices, a vertex is made halfway, and both are led through it:
/// in space an edge can cross another without passing by a vertex. Thus what rounding laid on its neighbour is laid
/// into it, and nothing stays nearly in contact there.
///
/// No point of the surface moves farther than `reach`.
/// @param rounded  the point of the grid for a new vertex, at most reach / 2 from it
/// @return the number of vertices, edges and faces snapped; 0 when nothing was changed
std::size_t snap_vertices(RoundedSurface& surface, const std::vector<TrianglePair>& contacts, double reach,
                          const std::function<Vec3(const Vec3&)>& rounded, const Progress& progress);

}  // namespace mq::boolean
