// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune the measuring of distances. docs/measurements/tuning.md says what each does at half and
/// at double its value.
struct MeasureTuning {
    /// Fraction of the tolerance: if this distance is expected away from the middle, it is measured there too.
    MESHQUALITY_TUNED(double, kWorthAsking, 0.8);
    /// Fraction of the tolerance: a curve with this chord error is also measured beside its farthest point.
    MESHQUALITY_TUNED(double, kWorthAskingCurve, 0.6);
    /// A CAD edge can deviate from its face by more than the tolerance. A distance counts as avoidable only if the
    /// share not caused by the edge exceeds this fraction of the tolerance: otherwise triangles would shrink
    /// without limit there.
    MESHQUALITY_TUNED(double, kAvoidable, 0.25);
    /// Fraction of the tolerance: an edge or triangle this close to it may exceed it beside the farthest place
    /// found, and is measured again beside that place.
    MESHQUALITY_TUNED(double, kClose, 0.95);
    /// Distance of these further places from an edge's farthest point, as a fraction of the edge's length.
    MESHQUALITY_TUNED(double, kAside, 0.06);
    /// Distance of these further places from a triangle's peak, as a fraction of the distance from the peak to a
    /// corner.
    MESHQUALITY_TUNED(double, kAsideOfPeak, 0.1);
    /// Denominator of the barycentric lattice of places examined in a triangle, except its sides.
    MESHQUALITY_TUNED(int, kLattice, 8);
    /// Largest number of steps from the triangle that has a point's parameters to the one under the point.
    MESHQUALITY_TUNED(int, kMaxSteps, 8);
};

}  // namespace mq::triangulate
