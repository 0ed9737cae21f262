// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::wrap {

/// The constants of wrapping, chosen on boxes and a few models. Their sensitivity was not measured.
struct WrapTuning {
    /// Rounds of smoothing of the triangles that close gaps.
    MESHQUALITY_TUNED(int, kSmoothing, 20);
    /// Nodes move only if each tetrahedron keeps this fraction of its volume.
    MESHQUALITY_TUNED(double, kFlatCell, 0.1);
    /// Largest distance of the simplified surface from the planes of the contour, in spacings.
    MESHQUALITY_TUNED(double, kSimplification, 0.1);
    /// Largest distance of borders between patches of the simplified surface from those of the contour, in spacings.
    MESHQUALITY_TUNED(double, kBorder, 0.4);
    /// Longest edge of the simplified surface, in spacings: with longer ones the tests of nearby triangles would take
    /// more time.
    MESHQUALITY_TUNED(double, kLongest, 10.0);
    /// Side of the blocks that are simplified in parallel, in spacings: far longer than the edges of the contour.
    MESHQUALITY_TUNED(double, kBlock, 24.0);
};

}  // namespace mq::wrap
