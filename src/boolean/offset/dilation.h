// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "boolean/arrangement/arrangement.h"
#include "boolean/arrangement/cells.h"
#include "mesh/intersection/nearest_tree.h"

namespace mq::boolean {

/// How the cells of an arrangement are told that lie within a distance of a surface.
struct DilationOptions {
    double distance = 0.0;   ///< mm
    double tolerance = 0.0;  ///< mm: larger than the error of the raw offset
    /// Whether the surface is oriented inward. Then all that is far outside counts as within the distance, and the
    /// result is what is not within it.
    bool inward = false;
};

/// Sets the winding number of each cell of a raw offset to 1 where the cell belongs to the offset solid, else to 0.
///
/// The raw offset winds around a point as often as the Euler characteristic of the ball's intersection with the solid
/// says (Guibas, Ramshaw and Stolfi 1983), which is 0 where that is a ring: so the winding number alone does not tell.
/// No point of the raw offset is farther from the surface than the distance; where one is nearer by more than the
/// tolerance, the cells on both of its sides are within. The others are bounded by points at the distance, where
/// winding numbers tell.
/// @param tree  of the surface
void settle_dilation(const Arrangement& arrangement, const mesh::NearestTree& tree, const DilationOptions& options,
                     Cells& cells, const Progress& progress);

}  // namespace mq::boolean
