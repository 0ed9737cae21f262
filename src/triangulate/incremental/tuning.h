// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune meshing after an edit. Their halves and doubles were not measured.
struct IncrementalTuning {
    /// Largest ratio between the cached and the present chord tolerance at which a cached mesh is reused.
    MESHQUALITY_TUNED(double, kMuchTheSame, 1.25);
    /// An edge counts as over-refined if its vertices outnumber the min_sample_count it had in any run by this
    /// factor.
    MESHQUALITY_TUNED(double, kOverRefined, 1.25);
};

}  // namespace mq::triangulate
