// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "boolean/soup.h"

namespace mq::boolean {

/// Moves the vertices of some triangles by at most `length` (mm) along each axis, at random but the same for the same
/// `draw`: for a result that rounding or parting spoiled. What is nearly degenerate for the operands as they are is not
/// so for operands beside them.
///
/// Of triangles of several operands those of the first one stay. The operands must not yet share vertices, see
/// merge_vertices.
/// @return the largest move, mm
double jolt(Soup& soup, const std::vector<std::int32_t>& triangles, double length, std::uint64_t draw);

/// Puts vertices back where moves, whoever made them, left a triangle without area.
/// @param before  where the vertices were
void undo_degenerate_moves(Soup& soup, const std::vector<Vec3>& before);

}  // namespace mq::boolean
