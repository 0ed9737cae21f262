// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::boolean {

/// The constants that tune the separation of nearly coincident surfaces. docs/measurements/tuning.md says what each
/// does at half and at double its value.
struct NearCoincidenceTuning {
    /// Least cosine between normals that count as parallel: less than 18 degrees, or more than 162.
    MESHQUALITY_TUNED(double, kParallelNormals, 0.95);
    /// Least cosine between the normals of a vertex and of the nearest triangle. It is low because a vertex on an
    /// edge has an averaged normal.
    MESHQUALITY_TUNED(double, kSameSideNormals, 0.3);
    /// Offset of a surface in units of the usual distance: large enough that surfaces which bend between their vertices
    /// stay separate.
    MESHQUALITY_TUNED(double, kOffsetStep, 3.0);
    /// Vertices sampled to estimate the usual distance of two surfaces.
    MESHQUALITY_TUNED(std::size_t, kDistanceSamples, 2000);
    /// The fraction of the sampled distances that is left out as outliers.
    MESHQUALITY_TUNED(double, kDistanceOutliers, 0.02);
    /// Least eigenvalue of the planes to be left that counts, as a fraction of the largest.
    MESHQUALITY_TUNED(double, kLeastEigenvalue, 0.01);
    /// Least cosine between the planes of a pair that count as parallel: 60 degrees.
    MESHQUALITY_TUNED(double, kParallelPlanes, 0.5);
    /// The crossing pairs, as a fraction of all triangles, from which crossings are a matter of areas, not of curves.
    MESHQUALITY_TUNED(double, kCrossingShare, 0.05);
    /// Least cosine to divide by: bounds the offset at spikes to five times the distance.
    MESHQUALITY_TUNED(double, kLeastOffsetCosine, 0.2);
};

}  // namespace mq::boolean
