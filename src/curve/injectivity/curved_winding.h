// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/vec.h"
#include "elements/bezier/simplex_lattice.h"

namespace mq::curve {

/// The winding number of a closed surface of Bezier triangles around a point: 1 if the point is inside and the
/// triangles are oriented outward, 0 outside.
///
/// Each triangle is halved until, for every piece, the distance of the point from the flat triangle between the piece's
/// corners is larger than the bend of the piece. The curved surface then does not pass the point while it is deformed
/// into the flat one, whose solid angles (Van Oosterom and Strackee 1983) are summed. If an edge is halved, the
/// triangle between the edge and the middle of its curve is added: so flat pieces of neighbours end in the same chords,
/// whichever way they are divided.
/// @param patches  their control points
/// @param margin   mm: least distance of the point from the surface
/// @return nothing if the point is nearer than that, or the surface is not closed
std::optional<int> curved_winding(const elements::Lattice& lattice, const std::vector<std::vector<Vec3>>& patches,
                                  const Vec3& point, double margin);

}  // namespace mq::curve
