// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "wrap/surface/contour.h"

namespace mq::wrap {

/// Collapses edges of the contour as long as the planes that its triangles stand for are within a tenth of the spacing
/// (collapse_edges). The planes of a cell with an edge are those of the input, so edges that the lattice has cut off
/// become sharp again. Borders between patches stay within four times that, and do not vanish.
///
/// First in blocks of space at once: each holds the triangles that are in it with all of their corners, and changes
/// nothing outside of itself, so that blocks do not meet. Triangles between blocks are fixed meanwhile. Then all that
/// is left together. The result is the same for any number of threads.
/// @throws Cancelled
void simplify(Contour& surface, const std::vector<Crossing>& crossings, double spacing, const Progress& progress);

}  // namespace mq::wrap
