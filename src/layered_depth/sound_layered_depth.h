// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "layered_depth/layered_depth_boolean.h"

namespace mq::boolean {

/// Makes the result of the uniform scheme sound: where its triangles cross or touch, as the paper's reconstruction and
/// triangles of operands that cross themselves may, it becomes the surface of what it winds around at least once, by
/// the exact arrangement of its triangles. Vertices of faulty triangles that are no operand's own are moved inward
/// first, by 1 to 3 % of the tolerance: sheets that the scheme laid on each other have no intersections that can be
/// rounded. A result without such faults stays as it is; else triangles without faults stay bit for bit, with their
/// sources. `retained`, `crossing_pairs` and the times are brought up to date; other counts are of the scheme's
/// surface.
/// @param tolerance  how far points may be moved where they are rounded, mm
/// @throws TopologyError where the surface cannot be held in single precision, Cancelled
void remove_crossings(UniformResult& result, double tolerance, Progress& progress);

/// The Boolean by layered depth images, made sound and measured: free of crossings (see remove_crossings), and with an
/// error bound that is measured both ways (see measure_error), to which how far operands were moved by their repair is
/// added.
/// @param tolerance  how far points may be moved where crossings are removed; samples of the measure lie this far
///     from each other at least, mm
/// @throws TopologyError where the result cannot be held in single precision
UniformResult sound_layered_depth_boolean(const std::vector<const mesh::TriangleMesh*>& operands,
                                          const Expression& expression, const LayeredDepthOptions& options,
                                          double tolerance, Progress& progress, const CadOperands& cad = {});

}  // namespace mq::boolean
