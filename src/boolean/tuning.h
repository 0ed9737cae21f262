// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>

#include "base/tuning.h"

namespace mq::boolean {

/// The constants that tune a Boolean and the projection of its result to the CAD.
/// docs/measurements/tuning.md says what each does at half and at double its value.
struct BooleanTuning {
    /// Least distance by which a common face of a later operand is moved beyond that of an earlier one, as a fraction
    /// of the size: some units in the last place of single precision, to which the moved vertices are rounded.
    MESHQUALITY_TUNED(double, kClearance, 32.0 * std::numeric_limits<float>::epsilon());
    /// Surfaces whose normals differ by less than this angle (radians) count as one where they are intersected.
    MESHQUALITY_TUNED(double, kLeastSurfaceAngle, 0.02);
};

}  // namespace mq::boolean
