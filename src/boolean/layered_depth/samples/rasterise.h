// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "boolean/layered_depth/samples/layered_depth_image.h"

namespace mq::boolean {

/// The highest resolution of rasterise(): 2^12 cells a side.
constexpr int kMaxLevels = 12;

/// Samples one operand (0 or 1) along all rays of the grid (Wang 2010, section II, step 1).
///
/// The rules are consistent: positions across the rays are integers (2^30 to the side of the grid), each edge decides
/// in exact arithmetic which rays pass on which side, the same way for all triangles that share it, and a ray through
/// an edge or a vertex counts as passing on the side of greater coordinates (symbolic perturbation). So a closed
/// operand has as many entries as exits on every ray. The operand may reach beyond the grid. Time O(triangles + rays +
/// samples log layers), on all cores.
/// @throws Cancelled
LayeredDepthSet rasterise(const OperandSet& pair, int operand, const SampleGrid& grid, const Progress* progress);

}  // namespace mq::boolean
