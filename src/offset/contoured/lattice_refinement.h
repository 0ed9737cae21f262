// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "contour/crossing.h"
#include "offset/contoured/distance_level_set.h"

namespace mq::offset {

/// A node of the lattice beside the contour.
struct LatticeNode {
    Vec3 place = Vec3::Zero();
    double value = 0.0;  ///< mm: value of the level set at the node
};

/// The cells whose contour is an offset, and a bound of its error.
struct RefinedCells {
    contour::CrossedCells crossed;
    /// mm, proven: no point outside of the contour is nearer to the surface than the distance less this bound, and no
    /// point inside is farther than the distance plus this bound.
    double bound = 0.0;
    std::vector<LatticeNode> nodes;  ///< corners of the cells that the contour crosses
};

/// Divides cells around the zero set of a distance until the contour of each cell is proven within a slack: the regions
/// of the cell on both sides of the contour are tetrahedra with its vertex, and SideProof shows on which side of the
/// offset they are. SideProof also shows that nothing is missed in cells without a contour. A cell without edges longer
/// than `finest` is not divided; its contour differs from the offset by at most |value| plus its diameter, which is
/// included in the bound.
/// @param slack  mm
/// @param finest  length of the edges of the finest cells, mm
/// @param box  contains the contour
/// @throws InvalidInput if the cells would not fit into memory
/// @throws Cancelled
RefinedCells refine(const DistanceLevelSet& level_set, const Box& box, double slack, double finest,
                    const Progress& progress);

}  // namespace mq::offset
