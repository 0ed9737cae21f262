// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::offset {

/// The constants of offsets. Their sensitivity was not measured.
struct ContouredOffsetTuning {
    /// Slack of the contour's proof, as a fraction of the tolerance.
    MESHQUALITY_TUNED(double, kSlack, 0.6);
    /// Error that the simplification of the contour may add, as a fraction of the tolerance.
    MESHQUALITY_TUNED(double, kSimplification, 0.6);
    /// Distances that differ by less than this fraction of the tolerance count as equal.
    MESHQUALITY_TUNED(double, kResolution, 0.01);
    /// Longest edge of the finest cells, as a fraction of the tolerance: no point of such a cell is farther than that
    /// from a contour through the cell.
    MESHQUALITY_TUNED(double, kFinest, 0.5);
    /// Number of cubes along the largest side of a model at the start.
    MESHQUALITY_TUNED(double, kCubes, 4.0);
    /// Distance between the lattice's first node and the box that it fills, in sides of the cubes.
    MESHQUALITY_TUNED(double, kShift, 0.0317);
    /// If the other side reaches across an edge, the edge is divided at least this fraction of its length from both
    /// ends.
    MESHQUALITY_TUNED(double, kFeatureEnds, 0.1);
    /// Nested divisions of a cell within a proof, before the cell itself is divided.
    MESHQUALITY_TUNED(int, kDivisions, 6);
    /// Most triangles that a proof evaluates before it divides.
    MESHQUALITY_TUNED(int, kMostAsked, 64);
    /// Most cells of the lattice, divided ones included: about 150 bytes each, and more for those that are crossed.
    MESHQUALITY_TUNED(double, kMostCells, 2e7);
    /// Rounds of simplification; in the last one the contour is not simplified.
    MESHQUALITY_TUNED(int, kRounds, 4);
    /// Largest difference between the asked distance and that of points of moved triangles, as a fraction of the
    /// tolerance.
    MESHQUALITY_TUNED(double, kNear, 0.9);
    /// Blocks along the largest side of a model in which a contour is simplified in parallel.
    MESHQUALITY_TUNED(double, kBlocks, 8.0);
};

}  // namespace mq::offset
