// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune the operators. docs/measurements/tuning.md says what each does at half and at double its
/// value.
struct OperatorTuning {
    /// On saddles the angles around an apex exceed 360 degrees in total: only this fraction of the required sum is
    /// demanded.
    MESHQUALITY_TUNED(double, kSaddle, 0.8);
    /// Steps of the pattern search for an apex.
    MESHQUALITY_TUNED(int, kSearchSteps, 14);
    /// Moves of that search before the step length shrinks.
    MESHQUALITY_TUNED(int, kMovesPerStep, 3);
    /// Factor by which the new triangle's angle on the shortest edge exceeds the bound, as a margin for rounding.
    MESHQUALITY_TUNED(double, kOffCentreSlack, 1.05);
    /// Largest distance between the off-centre and the surface, as a fraction of its distance from the edge: beyond
    /// it the planar construction does not apply.
    MESHQUALITY_TUNED(double, kMaxOffCentreLift, 0.5);
    /// Triangles visited around a new vertex, which bounds its cost.
    MESHQUALITY_TUNED(std::size_t, kMaxVisit, 400);
    /// Largest number of triangles in a cavity: a new vertex that needs more is refused.
    MESHQUALITY_TUNED(std::size_t, kMaxCavity, 40);
    /// Largest step inwards as a fraction of the distance to the centroid or the opposite corner: details as large
    /// as a triangle are to be meshed.
    MESHQUALITY_TUNED(double, kPartOfWay, 0.5);
};

}  // namespace mq::triangulate
