// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/angle.h"
#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune the initial triangulation. docs/measurements/tuning.md says what each does at half and
/// at double its value.
struct InitialTuning {
    /// Shortest side that is refined, in border deviations.
    MESHQUALITY_TUNED(double, kMinDeviations, 20.0);
    /// Smallest height and spacing, in border deviations.
    MESHQUALITY_TUNED(double, kMinHeights, 3.0);
    /// Radians: smallest turn of the normal that selects a side.
    MESHQUALITY_TUNED(double, kTurnThatCounts, 10.0 * kDegree);
    /// Smallest triangle to be refined, in sizes of the domain.
    MESHQUALITY_TUNED(double, kMinPart, 1e-4);
    /// Ratio of lengths from which only the longer piece is halved.
    MESHQUALITY_TUNED(double, kMuchLonger, 1.5);
    /// Largest number of halvings that lead to a vertex: at a kink the normal turns equally however short the sides
    /// become.
    MESHQUALITY_TUNED(int, kMaxLevel, 8);
    /// Rounds of refinement of one face.
    MESHQUALITY_TUNED(int, kMaxFaceRounds, 40);
    /// Rounds after which flips in space begin: triangles whose normal still deviates are slivers, which are
    /// Delaunay in (u, v) only, or lie beyond chords of the border.
    MESHQUALITY_TUNED(int, kPatience, 16);
    /// Vertices on one face, which bounds memory on faulty surfaces.
    MESHQUALITY_TUNED(int, kMaxSitesOfFace, 40000);
    /// Isoperimetric ratio 4 pi area / length^2: loops above it are not inverted by chords of pieces that turn by
    /// 45 degrees.
    MESHQUALITY_TUNED(double, kNarrowLoop, 0.3);
    /// Largest chord error as a fraction of a triangle's height: beyond it, triangles of a slender body cut through
    /// its other side.
    MESHQUALITY_TUNED(double, kMaxSag, 0.5);
};

}  // namespace mq::triangulate
