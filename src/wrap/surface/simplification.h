// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "wrap/surface/contour.h"

namespace mq::wrap {

/// Collapses edges of the contour as long as the planes that its triangles stand for are within a distance (Garland and
/// Heckbert 1997). The planes of a cell with an edge are those of the input, so edges that the lattice has cut off
/// become sharp again.
///
/// A collapse is made only where the surface stays 2-manifold (link condition) and no new triangle meets another one
/// (exact), so a contour without self-intersections stays without. Borders between patches stay within four
/// times the distance, and do not vanish.
/// @param patch  of each triangle
/// @param distance  from all planes, mm
/// @throws Cancelled
void simplify(Contour& surface, const std::vector<Crossing>& crossings, const std::vector<std::int32_t>& patch,
              double spacing, const Progress& progress);

}  // namespace mq::wrap
