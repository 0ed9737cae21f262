// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::wrap {

/// The constants of wrapping, chosen on boxes and a few parts; what each does at half and at double its value was not
/// measured.
struct WrapTuning {
    /// Normals that differ by more than the angle of this cosine meet in an edge: 25 degrees (Kobbelt et al. 2001 have
    /// 0.9 for their θ_sharp).
    MESHQUALITY_TUNED(double, kSharpCosine, 0.906);
    /// Principal values of the quadric below this fraction of the largest are no direction of its own.
    MESHQUALITY_TUNED(double, kFlatShare, 0.05);
    /// Barycentric coordinates of points in a tetrahedron or on a face are at least this, so that no triangle
    /// degenerates.
    MESHQUALITY_TUNED(double, kInset, 0.02);
    /// A crossing lies at least this fraction of its edge from both ends, for the same reason.
    MESHQUALITY_TUNED(double, kEndShare, 1e-3);
    /// Rounds in which what closes gaps is smoothed.
    MESHQUALITY_TUNED(int, kSmoothing, 20);
    /// Nodes move as long as the tetrahedra keep this fraction of their volumes.
    MESHQUALITY_TUNED(double, kFlatCell, 0.1);
    /// The simplified surface keeps within this fraction of the spacing of the planes of the contour.
    MESHQUALITY_TUNED(double, kSimplification, 0.1);
    /// Its edges are not longer than this, in spacings: what is to be asked of triangles near by would grow.
    MESHQUALITY_TUNED(double, kLongest, 10.0);
    /// Side of the blocks that are simplified at once, in spacings: far more than triangles are long at first.
    MESHQUALITY_TUNED(double, kBlock, 24.0);
    /// Where a triangle is moved, the cosine between its normal and that of its plane does not fall below this.
    MESHQUALITY_TUNED(double, kTurn, 0.8);
    /// Where a triangle is moved, the tangent of its smallest angle does not fall below this: 5 degrees.
    MESHQUALITY_TUNED(double, kThinTangent, 0.0875);
};

}  // namespace mq::wrap
