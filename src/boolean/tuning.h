// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <limits>

#include "base/tuning.h"

namespace mq::boolean {

/// The constants that tune the attempts of a Boolean and the projection of its result to the CAD.
/// docs/measurements/tuning.md says what each does at half and at double its value.
struct BooleanTuning {
    /// Faces nearer to each other than this fraction of the size count as coplanar within rounding.
    MESHQUALITY_TUNED(double, kFlush, 8.0 * std::numeric_limits<float>::epsilon());
    /// Further attempts after one that left faults, each with a larger perturbation of the operands at the faults.
    MESHQUALITY_TUNED(std::size_t, kFurtherAttempts, 6);
    /// A perturbation folds needles over each other, and larger ones would make it worse, when it has made more pairs
    /// cross than this multiple of those that did before ...
    MESHQUALITY_TUNED(std::size_t, kMorePairs, 4);
    /// ... and more than this number.
    MESHQUALITY_TUNED(std::size_t, kManyPairs, 500);
    /// First displacement of a perturbation, as a fraction of the size.
    MESHQUALITY_TUNED(double, kFirstDisplacement, 16.0 * std::numeric_limits<float>::epsilon());
    /// Each further attempt moves this many times farther than the one before.
    MESHQUALITY_TUNED(double, kMoreDisplacement, 4.0);
    /// Largest displacement, as a fraction of the tolerance: all attempts together stay within it.
    MESHQUALITY_TUNED(double, kLargestDisplacement, 0.08);
    /// Surfaces whose normals differ by less than this angle (radians) count as one where they are intersected.
    MESHQUALITY_TUNED(double, kLeastSurfaceAngle, 0.02);
    /// Newton steps of a projection at most; each about squares the distance.
    MESHQUALITY_TUNED(int, kProjectionSteps, 8);
    /// Rounds of undoing moves that made faults, before all are undone.
    MESHQUALITY_TUNED(int, kUndoRounds, 12);
};

}  // namespace mq::boolean
