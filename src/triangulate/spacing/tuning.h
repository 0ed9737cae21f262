// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune spacings, for sampling. docs/measurements/tuning.md says what each does at half and at
/// double its value.
struct SpacingTuning {
    /// Radians: a chord of 0.7 radii turns by 40 degrees.
    MESHQUALITY_TUNED(double, kChordTurn, 0.7);
    /// Sources in a leaf of the tree.
    MESHQUALITY_TUNED(int, kLeaf, 8);
    /// Longest side of a cell, in spacings.
    MESHQUALITY_TUNED(double, kCellOfSpacing, 1.0);
    /// Corners in one batch of queries.
    MESHQUALITY_TUNED(std::size_t, kCornersInBatch, 4096);
    /// Longest piece of an edge, in spacings, in which its curvature is measured.
    MESHQUALITY_TUNED(double, kEdgeMeasured, 2.0);
    /// Longest piece, in spacings, while arc lengths are integrated.
    MESHQUALITY_TUNED(double, kEdgeSummed, 0.5);
    /// Halvings of the interval between two samples.
    MESHQUALITY_TUNED(int, kMaxEdgeRounds, 24);
    /// Fraction of a spacing by which the number of pieces may be rounded down to a whole number.
    MESHQUALITY_TUNED(double, kStretch, 0.25);
};

}  // namespace mq::triangulate
