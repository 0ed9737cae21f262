// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "contour/crossing.h"
#include "offset/distance_level_set.h"

namespace mq::offset {

/// A point of the lattice beside the contour.
struct LatticeNode {
    Vec3 place = Vec3::Zero();
    double value = 0.0;  ///< what the level set is there, mm
};

/// The cells whose contour is an offset, and how near it is to that.
struct RefinedCells {
    contour::CrossedCells crossed;
    /// mm, proven: no point nearer to the surface than the distance less this is outside of the contour, and none
    /// farther than the distance and this is within it.
    double bound = 0.0;
    std::vector<LatticeNode> nodes;  ///< corners of the crossed cells
};

/// Divides cells around the zero set of a distance until the contour of each is proven within a slack of it: both sides
/// of the contour are tetrahedra with its vertex, and SideProof shows on which side they are. It also shows that
/// nothing is missed in cells without a contour. A cell of which no edge is longer than `finest` is not divided; its
/// contour is within |value| and its diameter of the offset, which is in the bound.
/// @param slack  mm
/// @param finest  length of the edges of the finest cells, mm
/// @param box  in which the contour lies
/// @throws InvalidInput where there would be more cells than fit into memory
/// @throws Cancelled
RefinedCells refine(const DistanceLevelSet& level_set, const Box& box, double slack, double finest,
                    const Progress& progress);

}  // namespace mq::offset
