// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/edge_bounds.h"

namespace mq::triangulate {

/// How fine the mesh must be at least.
struct Sizing {
    double tolerance = 0.0;  ///< mm; farthest from the part; 0: no bound
    EdgeBounds bounds;       ///< lengths of edges
    double turn = 0.0;       ///< radians: by how much the surface may turn along an edge; 0: no bound
    double growth = 0.0;  ///< how many times longer edges may be than those beside them (see graded_sizes); 0: no bound

    bool any() const { return tolerance > 0.0 || bounds.any() || turn > 0.0 || growth > 0.0; }
};

}  // namespace mq::triangulate
