// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::boolean {

/// The constants that divide the tolerance of an offset. What each does at half and at double its value was not
/// measured yet.
struct OffsetTuning {
    /// Error of the raw offset, as a fraction of the tolerance, at first ...
    MESHQUALITY_TUNED(double, kRawShare, 0.28);
    /// ... which is multiplied by this where the result misses the tolerance, ...
    MESHQUALITY_TUNED(double, kRefinement, 0.4);
    /// ... in this many rounds at most.
    MESHQUALITY_TUNED(int, kRounds, 4);
    /// Error of the raw offset, as a fraction of the tolerance, that normals of CAD faces may lead to: a point along
    /// one is nearer to the triangles than to the face. Below kDeepShare.
    MESHQUALITY_TUNED(double, kFaceShare, 0.5);
    /// The distance is larger by this fraction of the tolerance, so that gaps of just twice the distance close, where
    /// their sides would else touch.
    MESHQUALITY_TUNED(double, kOvershoot, 1.0 / 64.0);
    /// Points that are nearer to the surface than the distance by more than this fraction of the tolerance are within
    /// the offset.
    MESHQUALITY_TUNED(double, kDeepShare, 0.6);
    /// Fraction of the tolerance that rounding to single precision may use.
    MESHQUALITY_TUNED(double, kRoundingShare, 0.2);
    /// Fraction of the tolerance by which the offset of a sheet goes on beyond its border.
    MESHQUALITY_TUNED(double, kExtension, 0.25);
    /// How far at most a vertex is moved sideways from where a triangle's normal leads, as a fraction of the edges
    /// there: what is nearest to it is then in the ring of its triangles.
    MESHQUALITY_TUNED(double, kLargestShift, 1.0);
    /// Squares of the numbers of crossings of each triangle, summed up, at most, for each triangle of a raw offset.
    /// Dividing takes 0.5 to 3 us of the processor for each. So it takes at most a tenth of what a contour takes, about
    /// 300 us for each triangle, as it may be in vain: trimming may still miss the tolerance.
    MESHQUALITY_TUNED(double, kDivisions, 10.0);
    /// As many take at most a few seconds and are divided in any case.
    MESHQUALITY_TUNED(double, kLeastDivisions, 1.5e6);
    /// Fraction of the tolerance to which distances are determined.
    MESHQUALITY_TUNED(double, kFineness, 0.02);
};

}  // namespace mq::boolean
