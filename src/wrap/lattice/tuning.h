// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::wrap {

/// The constants of wrapping, chosen on boxes and a few parts; what each does at half and at double its value was not
/// measured.
struct WrapTuning {
    /// Rounds in which what closes gaps is smoothed.
    MESHQUALITY_TUNED(int, kSmoothing, 20);
    /// Nodes move as long as the tetrahedra keep this fraction of their volumes.
    MESHQUALITY_TUNED(double, kFlatCell, 0.1);
    /// The simplified surface keeps within this fraction of the spacing of the planes of the contour.
    MESHQUALITY_TUNED(double, kSimplification, 0.1);
    /// Borders between its patches keep within this of those of the contour.
    MESHQUALITY_TUNED(double, kBorder, 0.4);
    /// Its edges are not longer than this, in spacings: what is to be asked of triangles near by would grow.
    MESHQUALITY_TUNED(double, kLongest, 10.0);
    /// Side of the blocks that are simplified at once, in spacings: far more than triangles are long at first.
    MESHQUALITY_TUNED(double, kBlock, 24.0);
};

}  // namespace mq::wrap
