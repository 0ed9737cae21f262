// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "layered_depth/layered_depth_boolean.h"

namespace mq::layered_depth {

/// Makes the result of the uniform scheme sound if its triangles cross or touch, as after the paper's reconstruction or
/// for operands that cross themselves: by the exact arrangement of its triangles it becomes the boundary of the points
/// around which it winds at least once. First, vertices of faulty triangles that are no operand's own move inward by 1
/// to 3 % of the tolerance, since intersections of coinciding sheets cannot be rounded. A result without faults does
/// not change; triangles without faults stay bit for bit, with their sources. `retained`, `crossing_pairs` and the
/// times are brought up to date; other counts are of the scheme's surface.
/// @param tolerance  how far points may be moved where they are rounded, mm
/// @throws TopologyError where the surface cannot be held in single precision, Cancelled
void remove_crossings(UniformResult& result, double tolerance, Progress& progress);

/// The Boolean by layered depth images, free of crossings (see remove_crossings), with an error bound measured both
/// ways (see measure_error) plus the distance by which repair moved the operands.
/// @param tolerance  mm: how far removing crossings may move points, and the least distance between samples of the
///     error
/// @throws TopologyError where the result cannot be held in single precision
UniformResult sound_layered_depth_boolean(const std::vector<const mesh::TriangleMesh*>& operands,
                                          const boolean::Expression& expression, const LayeredDepthOptions& options,
                                          double tolerance, Progress& progress, const CadOperands& cad = {});

}  // namespace mq::layered_depth
