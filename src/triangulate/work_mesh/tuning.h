// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/angle.h"
#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune what all stages do with the work mesh. docs/measurements/tuning.md says what each does
/// at half and at double its value.
struct WorkMeshTuning {
    /// Sweeps of swaps over the mesh; the first ones make nearly all swaps.
    MESHQUALITY_TUNED(int, kMaxSweeps, 20);
    /// Radians: total angle around an apex below which fans need rings.
    MESHQUALITY_TUNED(double, kSlenderCone, 200.0 * kDegree);
    /// Fraction of the total angle: wider triangles lie deep below the cone and have to be divided by other
    /// vertices.
    MESHQUALITY_TUNED(double, kWidestShare, 145.0 / 360.0);
};

}  // namespace mq::triangulate
