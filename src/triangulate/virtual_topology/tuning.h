// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune meshing across edges. docs/measurements/tuning.md says what each does at half and at
/// double its value.
struct VirtualTopologyTuning {
    /// Fraction of the tolerance that changes must keep: between the measured points distances may be slightly
    /// larger.
    MESHQUALITY_TUNED(double, kCoarseningMargin, 0.9);
    /// Largest number of faces below one disc, which bounds the queries.
    MESHQUALITY_TUNED(std::size_t, kMaxFacesBelow, 12);
    /// Rounds of removal, each around the changes of the last one.
    MESHQUALITY_TUNED(int, kMaxCoarseningRounds, 16);
    /// Fans tried for one vertex.
    MESHQUALITY_TUNED(std::size_t, kMaxCoarseningFans, 3);
    /// Least number of equal pieces of an edge, at whose ends normals are compared: see smooth_edges().
    MESHQUALITY_TUNED(int, kLeastPieces, 8);
    /// Attempts: if faces cross after the removal, the vertices there are locked and the removal is repeated.
    MESHQUALITY_TUNED(int, kMaxRemovalAttempts, 4);
};

}  // namespace mq::triangulate
