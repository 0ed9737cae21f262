// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::offset {

/// The constants of offsets. What each does at half and at double its value was not measured yet.
struct ContouredOffsetTuning {
    /// Fraction of the tolerance within which the contour is proven.
    MESHQUALITY_TUNED(double, kSlack, 0.6);
    /// Fraction of the tolerance that its simplification may use.
    MESHQUALITY_TUNED(double, kSimplification, 0.6);
    /// Fraction of the tolerance below which a distance counts as the one asked for.
    MESHQUALITY_TUNED(double, kResolution, 0.01);
    /// Length of the edges of the finest cells, as a fraction of the tolerance: no point of such a cell is farther than
    /// that from a contour through it.
    MESHQUALITY_TUNED(double, kFinest, 0.5);
    /// Cubes along the largest side of a part at first.
    MESHQUALITY_TUNED(double, kCubes, 4.0);
    /// How far the lattice begins before what it holds, in sides of its cubes.
    MESHQUALITY_TUNED(double, kShift, 0.0317);
    /// Where the other side reaches across an edge, that is divided at least this fraction of its length from both
    /// ends.
    MESHQUALITY_TUNED(double, kFeatureEnds, 0.1);
    /// How often a cell is halved in a proof, before the cell itself is divided.
    MESHQUALITY_TUNED(int, kDivisions, 6);
    /// Triangles of which a proof asks before it divides.
    MESHQUALITY_TUNED(int, kMostAsked, 64);
    /// Cells of the lattice, divided ones too, at most: about 150 bytes for each, besides those that are crossed.
    MESHQUALITY_TUNED(double, kMostCells, 2e7);
    /// Rounds of simplification, the last of which leaves the contour as it is.
    MESHQUALITY_TUNED(int, kRounds, 4);
    /// Points of triangles are this fraction of the tolerance from the distance at most, before and after they move.
    MESHQUALITY_TUNED(double, kNear, 0.9);
    /// Blocks along the largest side of a part in which a contour is simplified at once.
    MESHQUALITY_TUNED(double, kBlocks, 8.0);
    /// Fraction of the tolerance to which distances are determined.
    MESHQUALITY_TUNED(double, kFineness, 0.02);
};

}  // namespace mq::offset
