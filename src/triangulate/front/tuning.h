// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune the triangulation of samples. docs/measurements/tuning.md says what each does at half
/// and at double its value.
struct FrontTuning {
    /// Darts in each generation of fragments before these are halved.
    MESHQUALITY_TUNED(int, kDarts, 4);
    /// Radians: below this angle two edges of the border count as tangent (a cusp).
    MESHQUALITY_TUNED(double, kCusp, 1e-3);
};

}  // namespace mq::triangulate
