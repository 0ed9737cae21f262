// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::contour {

/// The constants of contours and of their simplification, chosen on boxes and a few models. Their sensitivity was not
/// measured.
struct ContourTuning {
    /// Normals that differ by more than the angle of this cosine meet in an edge: 25 degrees (Kobbelt et al. 2001 have
    /// 0.9 for their θ_sharp).
    MESHQUALITY_TUNED(double, kSharpCosine, 0.906);
    /// Principal values of the quadric below this fraction of the largest one count as 0.
    MESHQUALITY_TUNED(double, kFlatShare, 0.05);
    /// Barycentric coordinates of points in a tetrahedron or on a face are at least this, so that no triangle
    /// degenerates.
    MESHQUALITY_TUNED(double, kInset, 0.02);
    /// A crossing lies at least this fraction of its edge from both ends, so that no triangle degenerates.
    MESHQUALITY_TUNED(double, kEndShare, 1e-3);
    /// Least cosine between the normal of a moved triangle and the normal of its plane.
    MESHQUALITY_TUNED(double, kTurn, 0.8);
    /// Least tangent of the smallest angle of a moved triangle: 5 degrees.
    MESHQUALITY_TUNED(double, kThinTangent, 0.0875);
};

}  // namespace mq::contour
