// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>

#include "base/angle.h"
#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune local optimisation. docs/measurements/tuning.md says what each does at half and at
/// double its value.
struct OptimisationTuning {
    /// Least gain of a change, as a fraction of the angle deficit, so that sequences of ever smaller changes end.
    MESHQUALITY_TUNED(double, kGainOfDeficit, 0.05);
    /// Radians: the least gain where the deficit is small.
    MESHQUALITY_TUNED(double, kLeastGain, 1e-6);
    /// Radians: the target lies above the bound by this margin, since the fraction of the deficit would approach the
    /// bound itself without reaching it.
    MESHQUALITY_TUNED(double, kTargetMargin, 0.002 * kDegree);
    /// Least limit of the attempts of all steps together, perturbations included.
    MESHQUALITY_TUNED(std::size_t, kLeastOfAll, 20'000);
    /// Attempts of all steps together for each triangle of the mesh. A crank arm at 30 degrees needs 27.
    MESHQUALITY_TUNED(std::size_t, kOfAllEach, 50);
    /// Cached cavities, which bounds memory.
    MESHQUALITY_TUNED(std::size_t, kMaxCached, 200'000);
    /// Triangles in a cavity: a fan with more has small angles in any case, and where a surface has a singular point,
    /// thousands of triangles meet in a vertex.
    MESHQUALITY_TUNED(std::size_t, kMaxDisc, 64);
    /// Fans tried for one cavity size.
    MESHQUALITY_TUNED(std::size_t, kMaxFans, 6);
    /// Attempts for each triangle that is bad at first.
    MESHQUALITY_TUNED(std::size_t, kAttemptsEach, 40);
    /// Attempts for the whole mesh, so that shapes full of needles end in reasonable time.
    MESHQUALITY_TUNED(std::size_t, kAttempts, 2000);
    /// Number of triangles of the mesh that allow one attempt more for the whole mesh.
    MESHQUALITY_TUNED(std::size_t, kTrianglesPerAttempt, 4);
    /// Triangles that may be added to a cavity, each across its worst side.
    MESHQUALITY_TUNED(int, kMaxGrowth, 3);
    /// Radians: triangles beside bad ones are improved by this angle beyond the bound.
    MESHQUALITY_TUNED(double, kRoomBesideBad, 3.0 * kDegree);
    /// Largest fraction of the deficit left after a round that lets another one follow.
    MESHQUALITY_TUNED(double, kLeftAfterRound, 0.95);
    /// Largest distance between an apex and its projection, as a fraction of the cavity's size, so that other
    /// sheets of the surface are excluded.
    MESHQUALITY_TUNED(double, kMaxApexLift, 0.5);
    /// Fraction of the bound that angles must keep during a perturbation.
    MESHQUALITY_TUNED(double, kLeastOfPerturbation, 0.2);
    /// Steps of the relocation of vertices along their CAD edges, as fractions of the distance to the next vertex in
    /// either direction.
    static constexpr std::array<double, 8> kEdgeSteps{-0.6, -0.45, -0.3, -0.15, 0.15, 0.3, 0.45, 0.6};
    /// Finer steps around the best of these, as the same fractions.
    static constexpr std::array<double, 4> kFineSteps{-0.1, -0.05, 0.05, 0.1};
    /// Positions tried for one vertex on a CAD edge.
    MESHQUALITY_TUNED(std::size_t, kMaxPositions, 3);
    /// Failed attempts (perturbations and their repairs) that the search may make besides kVainAttempts for each useful
    /// one. The remaining triangles share this number.
    MESHQUALITY_TUNED(int, kSearchAttempts, 20'000);
    /// Failed attempts for each one that led to a change.
    MESHQUALITY_TUNED(int, kVainAttempts, 4);
    /// Least number of attempts for each remaining triangle.
    MESHQUALITY_TUNED(int, kLeastShare, 600);
    /// Local repairs of each kind after a perturbation.
    MESHQUALITY_TUNED(int, kAttemptsAfter, 75);
    /// A perturbation is kept only if the total angle deficit falls to this fraction of its former value.
    MESHQUALITY_TUNED(double, kLeftAfterPerturbation, 0.95);
    /// Factor by which the angles after a removal exceed the bound, as a margin for later changes.
    MESHQUALITY_TUNED(double, kRemovalMargin, 1.04);
    /// Fraction of the tolerance. A vertex is kept if the chord error of an edge at it exceeds this: without the
    /// vertex edges become about twice as long, and their chord errors four times as large.
    MESHQUALITY_TUNED(double, kRemovalFlat, 0.6);
    /// Most rounds of vertex removal; the vertices of a round have no triangle in common.
    MESHQUALITY_TUNED(int, kMaxRemovalRounds, 12);
    /// Least factor by which angles below the bound must grow.
    MESHQUALITY_TUNED(double, kRemovalGain, 1.1);
    /// Smallest angle that may replace a smaller one, as a fraction of the bound.
    MESHQUALITY_TUNED(double, kNoNeedle, 0.1);
};

}  // namespace mq::triangulate
