// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune the division of edges. docs/measurements/tuning.md says what each does at half and at
/// double its value.
struct EdgeTuning {
    /// Radians: largest angle between the tangents along one piece (30 degrees).
    MESHQUALITY_TUNED(double, kMaxTurn, 0.5236);
    /// Halvings of one interval, since at a kink the tangent turns equally however short the interval is.
    MESHQUALITY_TUNED(int, kMaxDepth, 14);
    /// Largest fraction of an edge's length that the tolerance ball of a node may cover, however large its
    /// tolerance is.
    MESHQUALITY_TUNED(double, kMostOfEdge, 0.1);
    /// Radius of the ball around a node in distances of the edge's end from it, where nodes were contracted to one:
    /// the first piece deviates from the edge by at most 1 / 8 in direction.
    MESHQUALITY_TUNED(double, kGaps, 8.0);
    /// Faces with a border shorter than this number of shortest sides count as a point: if one of their edges
    /// collapsed, the others would coincide.
    MESHQUALITY_TUNED(double, kShortBorder, 8.0);
    /// Radians: edges at larger angles are told apart at once (30 degrees).
    MESHQUALITY_TUNED(double, kApart, 0.5236);
    /// Fraction of the shorter of two edges along which these may be too close together to be told apart: edges
    /// that stay so for longer bound a sliver, which has no other end to it.
    MESHQUALITY_TUNED(double, kMostUnresolved, 0.02);
};

}  // namespace mq::triangulate
