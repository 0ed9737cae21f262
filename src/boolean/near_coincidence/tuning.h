// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::boolean {

/// The constants that tune what is taken for a common face of two operands. docs/measurements/tuning.md says what each
/// does at half and at double its value.
struct NearCoincidenceTuning {
    /// Least cosine between the normals of triangles that face each other: 45 degrees.
    MESHQUALITY_TUNED(double, kParallelPlanes, 0.7);
    /// Least fraction of a region's area within twice the tolerance that must be within the tolerance if the region is
    /// a common face. For surfaces that cross the fraction is a half.
    MESHQUALITY_TUNED(double, kContactShare, 0.9);
    /// The least width of a common face, as a multiple of its gap. Places where surfaces happen to come near each other
    /// have 2.5 at most on the scans of the benchmarks, common faces 100 and more.
    MESHQUALITY_TUNED(double, kLeastWidth, 8.0);
    /// The largest gap of a pair of triangles in a common face, as a multiple of that of nine tenths of the area.
    MESHQUALITY_TUNED(double, kLargestGap, 4.0);
};

}  // namespace mq::boolean
