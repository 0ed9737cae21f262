// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::offset {

/// The constants that divide the tolerance of an offset. Their sensitivity was not measured.
struct OffsetTuning {
    /// Error of the raw offset in the first round, as a fraction of the tolerance.
    MESHQUALITY_TUNED(double, kRawShare, 0.35);
    /// Factor by which that error is reduced if the result misses the tolerance.
    MESHQUALITY_TUNED(double, kRefinement, 0.4);
    /// Rounds at most.
    MESHQUALITY_TUNED(int, kRounds, 4);
    /// Largest error of the raw offset through normals of CAD faces, as a fraction of the tolerance, below kDeepShare:
    /// a point along the face's normal is nearer to the triangles than to the face.
    MESHQUALITY_TUNED(double, kFaceShare, 0.5);
    /// The distance is increased by this fraction of the tolerance, so that gaps of exactly twice the distance close;
    /// otherwise the two offsets would touch.
    MESHQUALITY_TUNED(double, kOvershoot, 1.0 / 64.0);
    /// Points whose distance from the surface is less than the asked one by more than this fraction of the tolerance
    /// are inside the offset.
    MESHQUALITY_TUNED(double, kDeepShare, 0.6);
    /// The tolerance of rounding to single precision, as a fraction of the whole.
    MESHQUALITY_TUNED(double, kRoundingShare, 0.4);
    /// Fraction of the tolerance by which the offset of a sheet is extended beyond its border.
    MESHQUALITY_TUNED(double, kExtension, 0.25);
    /// Largest sideways shift of an offset vertex from the point to which a triangle's normal leads, as a fraction of
    /// the edges at the vertex: the triangle nearest to the offset vertex is then one of those around the vertex.
    MESHQUALITY_TUNED(double, kLargestShift, 1.0);
    /// Largest sum of the squared numbers of crossings of all triangles, per triangle of a raw offset. Dividing takes
    /// 0.5 to 3 us of the processor per unit of the sum. So dividing takes at most a tenth of the time of a contour,
    /// which is about 300 us per triangle, as it may be in vain: the trimmed offset may still miss the tolerance.
    MESHQUALITY_TUNED(double, kDivisions, 10.0);
    /// Sums up to this size take a few seconds at most and are divided in any case.
    MESHQUALITY_TUNED(double, kLeastDivisions, 1.5e6);
    /// Fraction of the tolerance to which distances are determined.
    MESHQUALITY_TUNED(double, kFineness, 0.02);
};

}  // namespace mq::offset
