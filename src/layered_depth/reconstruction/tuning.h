// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::layered_depth {

/// The constants that tune the surface of layered-depth samples. docs/measurements/tuning.md says what each does at
/// half and at double its value.
struct ReconstructionTuning {
    /// Singular values below this fraction of the largest count as zero: planes that differ by less than about 6
    /// degrees do not define an edge.
    MESHQUALITY_TUNED(double, kSingular, 0.1);
    /// A minimiser outside of the box by at most this distance (grid units) is moved to its wall; farther ones are
    /// rejected.
    MESHQUALITY_TUNED(double, kOvershoot, 0.3);
    /// The largest distance of a minimiser from a sample's plane, in units of r (section III-A).
    MESHQUALITY_TUNED(double, kFlatness, 0.1);
    /// The least distance of a vertex from the walls of its cell, in units of the cell: no two vertices coincide.
    MESHQUALITY_TUNED(double, kInset, 1e-3);
    /// The distance by which the copies of an opened node are separated, in units of r.
    MESHQUALITY_TUNED(double, kParting, 0.02);
};

}  // namespace mq::layered_depth
