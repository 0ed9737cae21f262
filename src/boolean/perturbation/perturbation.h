// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "boolean/arrangement/soup.h"

namespace mq::boolean {

/// Perturbs the vertices of some triangles by at most `length` (mm) along each axis, with random numbers that depend on
/// `draw` only: for a result with faults from rounding or separation. Near-degeneracies of the operands as they are
/// vanish for perturbed ones.
///
/// Where the triangles belong to several operands those of the first one stay. The operands must not yet share
/// vertices, see merge_vertices.
/// @return the largest displacement, mm
double perturb(Soup& soup, const std::vector<std::int32_t>& triangles, double length, std::uint64_t draw);

/// Puts vertices back where displacements left a triangle without area.
/// @param before  where the vertices were
void undo_degenerate_moves(Soup& soup, const std::vector<Vec3>& before);

}  // namespace mq::boolean
