// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "base/progress.h"
#include "geometry/initial_triangulation.h"

namespace mq::geometry {

/// How often faces are triangulated anew at most, each time over chains with more pieces.
struct RoundLimits {
    int rounds;   ///< in all; a gap of 1e-6 of an edge takes twenty
    int shaping;  ///< in which faces may ask for shorter pieces to follow their surface; later only to untangle borders
};

/// One face of the result over its present chains.
using FaceTriangulator = std::function<void(int face, bool border_may_change)>;

/// Triangulates the `open` faces of the result, halves the pieces of CAD edges that stand in the way of some, and goes
/// on with all faces beside those, until none is open. Wishes that cannot be granted do not count in the end. Adds to
/// the failures of the result. Faces that are not `included` are left alone.
/// @throws Cancelled
void triangulate_in_rounds(Session& session, InitialTriangulation& result, std::vector<int> open,
                           const RoundLimits& limits, Progress& progress, const std::function<bool(int)>& included,
                           const FaceTriangulator& triangulate);

}  // namespace mq::geometry
