// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "base/progress.h"
#include "triangulate/initial/initial_triangulation.h"

namespace mq::triangulate {

/// Limits of the rounds in which faces are triangulated again, each time over chains with more pieces.
struct RoundLimits {
    int rounds;  ///< all rounds; to resolve a gap of 1e-6 of an edge takes twenty
    /// Rounds in which faces may request shorter pieces to follow their surface; later rounds only untangle borders.
    int shaping;
};

/// Triangulates one face of the result over its present chains.
using FaceTriangulator = std::function<void(int face, bool border_may_change)>;
/// Likewise, called by several threads at a time, each with an oracle of its own.
using ParallelFaceTriangulator = std::function<void(geometry::Oracle& oracle, int face, bool border_may_change)>;

/// Triangulates the `open` faces of the result, halves the pieces of CAD edges that obstruct them, and continues with
/// all faces beside those, until none is open. Requests that cannot be granted are dropped in the end. Adds to the
/// failures of the result. Faces that are not `included` remain unchanged.
/// @throws Cancelled
void triangulate_in_rounds(geometry::Session& session, InitialTriangulation& result, std::vector<int> open,
                           const RoundLimits& limits, Progress& progress, const std::function<bool(int)>& included,
                           const FaceTriangulator& triangulate);
/// Likewise on as many threads as the caller may use. The result does not depend on their number.
void triangulate_in_rounds(geometry::Session& session, InitialTriangulation& result, std::vector<int> open,
                           const RoundLimits& limits, Progress& progress, const std::function<bool(int)>& included,
                           const ParallelFaceTriangulator& triangulate);

}  // namespace mq::triangulate
