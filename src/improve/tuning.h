// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/angle.h"
#include "base/tuning.h"

namespace mq::improve {

/// The constants that tune the improvement of meshes. docs/measurements/tuning.md says what each does at half and
/// at double its value.
struct ImproveTuning {
    /// Least cosine between a triangle's normal and the surface's: 60 degrees.
    MESHQUALITY_TUNED(double, kSameSide, 0.5);
    /// Least gain of a move in degrees. Vertices that keep moving by small steps would delay more effective
    /// changes.
    MESHQUALITY_TUNED(double, kLeastAngleGain, 1.0);
    /// Times that a mesh with more faults than the given one is improved again, with the places of these left alone;
    /// then it is given back as it was.
    MESHQUALITY_TUNED(int, kRepeats, 8);
    /// Rounds in which vertices are only removed, moved and swapped, before new ones are inserted.
    MESHQUALITY_TUNED(int, kRoundsWithoutSplits, 6);
    /// Triangles at most, as a multiple of the given ones: refinement near small angles of sharp edges would not
    /// end by itself.
    MESHQUALITY_TUNED(int, kMostGrowth, 6);
    /// Triangles allowed in addition, so that small meshes can be refined.
    MESHQUALITY_TUNED(int, kMoreTriangles, 2000);
    /// Times that an edge of the given mesh may be halved.
    MESHQUALITY_TUNED(int, kMostEdgeHalvings, 10);
    /// Least length of a halved edge, in units of single precision at the model's size.
    MESHQUALITY_TUNED(double, kShortestUnits, 64.0);
    /// Angle between sharp edges, radians, below which they are divided alike.
    MESHQUALITY_TUNED(double, kNarrowEdges, 60.0 * kDegree);
};

}  // namespace mq::improve
