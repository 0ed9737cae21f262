// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "layered_depth/samples/layered_depth_image.h"
#include "layered_depth/samples/node_consistency.h"
#include "mesh/intersection/surface_winding.h"

namespace mq::layered_depth {

struct WindingSampleCounts {
    std::size_t kept = 0;     ///< samples on triangles at which the ray changes between inside and outside
    std::size_t dropped = 0;  ///< samples on triangles that have the same side before and behind them
    std::size_t guessed = 0;  ///< samples without a triangle at which the ray changes between inside and outside
    double kept_area = 0.0;   ///< area that the samples on triangles represent, in squared distances between rays
    double guessed_area = 0.0;
    ConsistencyCounts nodes;
};

/// Turns the samples of an operand that is no closed surface into those of a solid: the points of its box at which the
/// generalised winding number of its triangles is at least 0.5.
///
/// A sample is kept if the winding number crosses 0.5 on its triangle. If the number crosses 0.5 between triangles,
/// through a hole of the surface, a sample is made there: its normal is the direction of steepest descent, its triangle
/// the first edge of the operand's border. So every ray leaves the operand as often as it enters it.
///
/// The border bounds how fast the number changes between triangles. So the number is evaluated in blocks of the grid
/// that grow with the distance from the border; it is evaluated at nodes of the grid, and in the middle between
/// samples, only if the bound leaves a doubt. Features narrower than the distance between rays can be missed there, as
/// everywhere in this method. Time about O(surface in blocks + border zone in nodes), on all cores.
/// @param winding of the operand's triangles, in the frame of the grid
/// @throws Cancelled
void sample_by_winding(LayeredDepthSet& set, const OperandSet& operands, int operand, const SampleGrid& grid,
                       const mesh::SurfaceWinding& winding, WindingSampleCounts& counts, const Progress* progress);

}  // namespace mq::layered_depth
