// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::contour {

/// The constants of contours and of their simplification, chosen on boxes and a few parts; what each does at half and
/// at double its value was not measured.
struct ContourTuning {
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
    /// Where a triangle is moved, the cosine between its normal and that of its plane does not fall below this.
    MESHQUALITY_TUNED(double, kTurn, 0.8);
    /// Where a triangle is moved, the tangent of its smallest angle does not fall below this: 5 degrees.
    MESHQUALITY_TUNED(double, kThinTangent, 0.0875);
};

}  // namespace mq::contour
