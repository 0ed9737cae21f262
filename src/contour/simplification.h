// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "contour/contour.h"
#include "contour/edge_collapse.h"

namespace mq::contour {

/// Collapses edges of a contour as long as its vertices stay within a distance of the planes that the triangles stand
/// for (collapse_edges). If these planes are those of the input, edges that the lattice has cut off become sharp again.
/// Borders between patches stay within a distance of the original borders, and do not vanish.
///
/// First, blocks of space are simplified in parallel: each holds the triangles whose corners are all in it, and changes
/// nothing outside of itself, so that blocks do not meet. Triangles between blocks are fixed meanwhile. Then the rest
/// is simplified together. The result is the same for any number of threads.
/// @param limits  whose `fixed` goes by the triangles that surface.source names, and whose `within` is empty
/// @param block  mm: side of the blocks, which should be far longer than the edges of triangles
/// @throws Cancelled
void simplify(Contour& surface, const std::vector<Crossing>& crossings, const CollapseLimits& limits, double block,
              Progress& progress);

}  // namespace mq::contour
