// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::curve {

/// The constants that tune the curving of surfaces. docs/measurements/tuning.md says what each does at half and at
/// double its value.
struct SurfaceTuning {
    /// Largest deviation from the chord as a fraction of its length: 0.134 is an arc of 60 degrees; beyond
    /// sqrt(3)/4 = 0.433 even the best triangle becomes invalid (inequality (4) of section 5.5).
    MESHQUALITY_TUNED(double, kAllowableBulge, 0.134);
    /// Quality from which a triangle needs no repair; worse ones belong to cavities.
    MESHQUALITY_TUNED(double, kGoodTriangle, 0.15);
    /// A triangle below this quality is hardly valid: all its vertices may lie on one CAD edge.
    MESHQUALITY_TUNED(double, kHardlyValid, 0.02);
    /// Edges whose deviation is below this fraction of the height of the triangle on them are not the reason for
    /// its fold.
    MESHQUALITY_TUNED(double, kBulges, 0.05);
    /// Rounds of halving edges at most: where a curve has a corner, or faces touch each other, no edge is short enough.
    MESHQUALITY_TUNED(int, kHalvingRounds, 6);
    /// Refining a face around its invalid triangles ends when their number has grown by this factor.
    MESHQUALITY_TUNED(int, kRunaway, 4);
    /// Least gain in the worst quality of the triangles of an operation that makes no more of them valid.
    MESHQUALITY_TUNED(double, kLeastQualityGain, 0.05);
    /// Epsilon of (7), as a fraction of |t2 x t1|^2: the fraction of the straight triangle's corner that is to be
    /// restored.
    MESHQUALITY_TUNED(double, kRestoredCorner, 0.3);
    /// Least cosine between the normals of straight triangles and of those that they replace.
    MESHQUALITY_TUNED(double, kStraightTurn, 0.2);
    /// Triangles sampled for the deviation of the surface.
    MESHQUALITY_TUNED(std::size_t, kDeviationSamples, 2000);
    /// Largest distance of a mesh vertex from its CAD vertex, as a fraction of the size: vertices of rough shapes lie
    /// beside the ends of their edges.
    MESHQUALITY_TUNED(double, kNearVertex, 4e-3);
    /// Corners whose curved angle is below this fraction of the straight one are cusps.
    MESHQUALITY_TUNED(double, kCuspShare, 0.3);
    /// Quality from which the triangle in the cusp needs no further attempt.
    MESHQUALITY_TUNED(double, kCuspQuality, 0.16);
    /// Deviation of the triangles beside an opened cusp at most, as a fraction of the plain surface's deviation.
    MESHQUALITY_TUNED(double, kCuspDeviation, 0.25);
    /// Smallest straight angle (radians) to which cusps are refined: halving the edges halves the angle between
    /// their chords.
    MESHQUALITY_TUNED(double, kThinnestCusp, 0.02);
    /// The distance of an end from the CAD, as a fraction of the mesh edge, from which it is a gap: nodes on the
    /// CAD would change the direction of a cubic by a tenth.
    MESHQUALITY_TUNED(double, kGapShare, 0.02);
    /// Quality below which both ways to place the nodes of a triangle are compared.
    MESHQUALITY_TUNED(double, kWorthComparing, 0.3);
    /// Distance of the point inside a triangle where the CAD normal of a corner is taken from the corner, as a fraction
    /// of the way to the centroid.
    MESHQUALITY_TUNED(double, kInsideCorner, 0.05);
    /// Newton steps towards even arc lengths; each about squares the error.
    MESHQUALITY_TUNED(int, kArcRounds, 3);
    /// Newton steps towards even distances inside faces; the nodes need not be exact.
    MESHQUALITY_TUNED(int, kEvenRounds, 2);
    /// The largest distance of a vertex from the CAD edge, as a fraction of the edge's distance from the mesh edge
    /// on it, at which the triangle between them has nearly no area.
    MESHQUALITY_TUNED(double, kHugs, 0.05);
    /// Pairs found in one search at most: enough for a round of splits.
    MESHQUALITY_TUNED(std::size_t, kMostCrossings, 500);
};

}  // namespace mq::curve
