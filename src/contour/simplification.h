// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "contour/contour.h"
#include "contour/edge_collapse.h"

namespace mq::contour {

/// Collapses edges of a contour as long as the planes that its triangles stand for are within a distance
/// (collapse_edges). Where these are the input's, edges that the lattice has cut off become sharp again. Borders
/// between patches stay within a distance of their own, and do not vanish.
///
/// First in blocks of space at once: each holds the triangles that are in it with all of their corners, and changes
/// nothing outside of itself, so that blocks do not meet. Triangles between blocks are fixed meanwhile. Then all that
/// is left together. The result is the same for any number of threads.
/// @param limits  without fixed triangles and `within`
/// @param block  side of the blocks, mm: far more than triangles are long
/// @throws Cancelled
void simplify(Contour& surface, const std::vector<Crossing>& crossings, const CollapseLimits& limits, double block,
              Progress& progress);

}  // namespace mq::contour
