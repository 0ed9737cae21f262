// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/angle.h"
#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune refinement. docs/measurements/tuning.md says what each does at half and at double its
/// value.
struct RefinementTuning {
    /// Largest number of sites that are projected in one round.
    MESHQUALITY_TUNED(std::size_t, kMaxSites, 512);
    /// Least number of sites in a round.
    MESHQUALITY_TUNED(std::size_t, kMinSites, 32);
    /// Between the two a round takes the queue's length over this number, so that the worst triangles still come
    /// first.
    MESHQUALITY_TUNED(std::size_t, kSharesOfQueue, 8);
    /// Times that exempt triangles are tried again.
    MESHQUALITY_TUNED(int, kMaxRetries, 6);
    /// Largest number of insertions closer than the triangle's shortest edge in the ancestry of a vertex; see
    /// AngleRefinement::crowded.
    MESHQUALITY_TUNED(int, kMaxShrinks, 8);
    /// Least distance of such an insertion, as a fraction of the shortest edge.
    MESHQUALITY_TUNED(double, kMaxShrink, 0.5);
    /// Times the edges at one vertex are halved because the angle between their chords is smaller than theirs.
    MESHQUALITY_TUNED(int, kMaxSharpened, 16);
    /// Times the innermost shell around a CAD node is halved for triangles that its pieces leave below the bound.
    MESHQUALITY_TUNED(int, kMaxShellHalvings, 4);
    /// Fraction of the shape's size: at the tip of a wing the normal turns within the resolution, and triangles
    /// below this size are not refined only because their normal deviates.
    MESHQUALITY_TUNED(double, kMinTurned, 1e-3);
    /// Radians: angle of each of a few triangles around an apex. Smaller angles would not survive changes around
    /// them, larger ones would waste triangles.
    MESHQUALITY_TUNED(double, kFewAtApex, 40.0 * kDegree);
    /// Factor by which the angles of a ring exceed the bound.
    MESHQUALITY_TUNED(double, kRingSlack, 1.15);
    /// Rings around one apex: those that halve the number of triangles, and a reserve for changes in between.
    MESHQUALITY_TUNED(int, kMaxRings, 48);
    /// Swaps before one ring.
    MESHQUALITY_TUNED(int, kMaxRingSwaps, 16);
    /// Rings that may leave too many triangles before the apex is left to ordinary refinement.
    MESHQUALITY_TUNED(int, kMaxRingMisses, 2);
    /// Fraction of a full turn: a triangle that spans more lies deep below its cone, and a ring would fold over it.
    MESHQUALITY_TUNED(double, kWidestBelowRing, 100.0 / 360.0);
    /// Ratio of distances from the apex up to which a vertex counts as on the ring.
    MESHQUALITY_TUNED(double, kOnRing, 1.05);
    /// Fraction of the chord tolerance that the middles of a ring's chords may use.
    MESHQUALITY_TUNED(double, kRingChordHeight, 0.9);
    /// Least distance of a ring, as a fraction of the distance without a chord tolerance. Chords of a coarse
    /// initial triangulation lie so deep below a cone that rings that keep the tolerance at once would crowd around
    /// the apex.
    MESHQUALITY_TUNED(double, kLeastRing, 0.1);
    /// Rounds of splitting in one run of chord refinement.
    MESHQUALITY_TUNED(int, kMaxSplitRounds, 60);
    /// The longest edge of triangles with good angles, in local sizes: edges around one vertex differ.
    MESHQUALITY_TUNED(double, kLongestEdge, 1.6);
    /// Largest radius of the innermost shell in lengths of an edge that is a single piece, which has a corner at
    /// its other end, too.
    MESHQUALITY_TUNED(double, kShellOfWholeEdge, 0.6);
    /// Likewise, if the edge joins two nodes with small input angles and is a side of neither angle.
    MESHQUALITY_TUNED(double, kShellBetweenTwo, 0.75);
    /// Largest radius in distances from the node to the nearest vertex that does not belong to the corner, on a
    /// face beside the node: entities that are merely close in space, such as nodes of separate bodies, do not
    /// restrict it.
    MESHQUALITY_TUNED(double, kShellRoom, 0.9);
    /// Largest radius in distances from the node to an edge that passes by.
    MESHQUALITY_TUNED(double, kShellPassing, 1.2);
    /// Least distance of an edge from the middle of an innermost piece, in lengths of the piece: the radius is
    /// halved until it is reached.
    MESHQUALITY_TUNED(double, kShellBesideEdge, 0.3);
    /// Radians: widest corner beyond whose innermost pieces the edges are divided as the rails of a ladder.
    MESHQUALITY_TUNED(double, kWidestLadder, 15.0 * kDegree);
    /// Radians: margin of the angles between rails over the bound.
    MESHQUALITY_TUNED(double, kLadderMargin, 5.0 * kDegree);
    /// Radians: margin of the angles of a graded fan over the bound, and that of fans that have no room for it.
    MESHQUALITY_TUNED(double, kFanMargin, 1.0 * kDegree);
    MESHQUALITY_TUNED(double, kLeastFanMargin, 0.1 * kDegree);
    /// Least distance of other vertices from those of a graded fan, in lengths of the spokes.
    MESHQUALITY_TUNED(double, kFanRoom, 0.6);
    /// Triangles that a graded fan may replace.
    MESHQUALITY_TUNED(std::size_t, kMostUnderFan, 400);
    /// Passes over doubled edges in one round: an edge beside one that was split may have to wait for the next.
    MESHQUALITY_TUNED(int, kMaxPassesOfDoubled, 8);
    /// Exempt triangles on a face before its floor is raised first: tips of wings and similar places have about ten
    /// each.
    MESHQUALITY_TUNED(std::size_t, kExemptBeforeFloor, 128);
    /// Further exempt triangles before the floor is raised again.
    MESHQUALITY_TUNED(std::size_t, kExemptBetweenFloors, 32);
    /// Factor by which a floor is raised.
    MESHQUALITY_TUNED(double, kFloorRise, 2.0);
    /// Depth of a crossing in heights of both triangles over their surfaces: deeper crossings are not caused by
    /// chords.
    MESHQUALITY_TUNED(double, kDeepCrossing, 2.0);
    /// Sides with a smaller height over the surface, in resolutions of single precision, count as exact.
    MESHQUALITY_TUNED(double, kExactHeight, 4.0);
    /// Distance from a node, in radii of its innermost shell, within which vertices count as obstructed by its
    /// small angle.
    MESHQUALITY_TUNED(double, kBesideShell, 1.5);
    /// Ratio of lengths up to which two pieces count as on one shell.
    MESHQUALITY_TUNED(double, kSameShell, 1.1);
    /// Least alignment (a cosine) of the new triangles beside a split segment: below it they count as folded.
    MESHQUALITY_TUNED(double, kNotFolded, 0.1);
    /// Times a segment is postponed for the sake of another one.
    MESHQUALITY_TUNED(int, kMaxPostponed, 12);
    /// Runs of chord refinement: each may split a single edge, whose swaps create the next edge beyond the
    /// tolerance.
    MESHQUALITY_TUNED(int, kMaxChordRounds, 60);
    /// Rounds of splitting triangles that cross.
    MESHQUALITY_TUNED(int, kMaxCrossingRounds, 24);
    /// Rounds of splitting triangles of different bodies that cross.
    MESHQUALITY_TUNED(int, kMaxBodyRounds, 16);
    /// Least gap between bodies, as a fraction of the tolerance, for which their triangles are split.
    MESHQUALITY_TUNED(double, kLeastGap, 1.0 / 16.0);
    /// Factor in the number of triangles by which splitting for gaps between bodies may let the mesh grow.
    MESHQUALITY_TUNED(double, kMostForBodies, 8.0);
    /// Rounds of separating doubled edges.
    MESHQUALITY_TUNED(int, kMaxDoubledRounds, 4);
    /// Size below which details of normals are ignored, as a fraction of the shape's size; limited by the
    /// tolerance.
    MESHQUALITY_TUNED(double, kSmallestDetail, 1e-3);
};

}  // namespace mq::triangulate
