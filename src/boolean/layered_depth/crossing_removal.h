// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "boolean/layered_depth/layered_depth_boolean.h"

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

}  // namespace mq::boolean
