// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/vec.h"
#include "curve/bezier/simplex_lattice.h"

namespace mq::curve {

/// How often a closed surface of Bezier triangles goes round a point: 1 where the point is inside, seen from which the
/// triangles turn the right way round, 0 outside.
///
/// Each triangle is halved until the point is farther from the flat triangle between the corners of every piece than
/// the piece bends. The surface then does not pass the point on its way to the flat one, whose solid angles
/// (Van Oosterom and Strackee 1983) are summed. Where an edge is halved, the triangle between it and the middle of its
/// curve is added: so flat pieces of neighbours end in the same chords, however they are divided.
/// @param patches  control points
/// @param margin   mm, by which the point must be off the surface
/// @return nothing where the point is nearer than that, or the surface is not closed
std::optional<int> winding_number(const Lattice& lattice, const std::vector<std::vector<Vec3>>& patches,
                                  const Vec3& point, double margin);

}  // namespace mq::curve
