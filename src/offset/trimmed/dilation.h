// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "boolean/arrangement/arrangement.h"
#include "boolean/arrangement/cells.h"
#include "mesh/intersection/nearest_tree.h"

namespace mq::offset {

/// How assign_dilation() tells the cells of an arrangement that lie within a distance of a surface.
struct DilationOptions {
    double distance = 0.0;   ///< mm
    double tolerance = 0.0;  ///< mm: larger than the error of the raw offset
    /// Whether the surface is oriented inward. Then all points far outside count as within the distance, and the result
    /// is all that is not within it.
    bool inward = false;
};

/// Sets the winding number of each cell of a raw offset to 1 if the cell belongs to the offset solid, else to 0.
///
/// The raw offset winds around a point as often as the Euler characteristic of the ball's intersection with the solid
/// says (Guibas, Ramshaw and Stolfi 1983). That is 0 if the intersection is a ring: so the winding number alone does
/// not decide. No point of the raw offset is farther from the surface than the distance. If a point of its surface is
/// nearer by more than the tolerance, the cells on both sides of it are within the offset. All other cells are bounded
/// by points at the distance; for these the winding number decides.
/// @param tree  the triangles of the surface
void assign_dilation(const boolean::Arrangement& arrangement, const mesh::NearestTree& tree,
                     const DilationOptions& options, boolean::Cells& cells, const Progress& progress);

}  // namespace mq::offset
