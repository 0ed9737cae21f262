// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::boolean {

/// The constants that tune the rounding to single precision. docs/measurements/tuning.md says what each does at
/// half and at double its value.
struct RoundingTuning {
    /// A surface with more than this number of faults, and more faults than triangles, is given up.
    MESHQUALITY_TUNED(std::size_t, kTangle, 10000);
    /// Largest move of a vertex by relocation in one round, in units of single precision at the farthest vertex ...
    MESHQUALITY_TUNED(double, kRelocationUnits, 80.0);
    /// ... and as a fraction of the tolerance.
    MESHQUALITY_TUNED(double, kRelocationShare, 0.05);
    /// Distance to which copies of a vertex are separated, in units of single precision of the size.
    MESHQUALITY_TUNED(double, kSeparationUnits, 80.0);
    /// The length of the sum of the normals at a vertex, as a fraction of the sum of the angles, below which the
    /// material is a thin wedge.
    MESHQUALITY_TUNED(double, kThinWedge, 0.2);
    /// Largest displacement of a copy of a vertex, as a fraction of its shortest edge, so that no triangle turns over.
    MESHQUALITY_TUNED(double, kCopyPartOfEdge, 0.1);
};

}  // namespace mq::boolean
