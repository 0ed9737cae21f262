// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Whether a triangle of the filling, by its three positions in the loop, is to be avoided.
using AvoidTriangle = std::function<bool(const Triangle&)>;

/// Most vertices of a loop that is triangulated at once; longer loops are divided first, as the time is cubic.
constexpr std::size_t kLongestWholeLoop = 300;

/// The triangulation of least area of a closed polygon in space, by dynamic programming over its chords (Barequet and
/// Sharir 1995, section 3): time O(n^3), memory O(n^2), 0.03 s for 300 vertices.
///
/// The loop has at least three vertices. The n - 2 triangles name positions in the loop and have its directed edges
/// loop[i] -> loop[i + 1]; to close a hole, give its border against the direction of the triangles around it. No vertex
/// is added.
///
/// A triangulation with fewer triangles that are degenerate (exactly) or that `avoid` refuses is preferred whatever its
/// area; if every triangulation has such triangles, the result has some, too. `avoid` is asked once for a triangle at
/// most.
///
/// Loops of more than kLongestWholeLoop vertices are first divided, again and again, along the shortest chord between
/// vertices that lie a quarter of the loop apart or more; the area is then not the least.
///
/// @throws Cancelled
std::vector<mesh::Triangle> fill_hole(const std::vector<Vec3>& loop, const AvoidTriangle& avoid = {},
                                      const Progress* progress = nullptr);

}  // namespace mq::mesh
