// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/work_mesh/surface_alignment.h"

namespace mq::triangulate {

/// The triangles to be removed so that a new vertex p can be joined to the whole boundary around it without folds.
struct InsertionCavity {
    std::vector<int> triangles;
    std::vector<int> rim;  ///< half-edges of these triangles on the boundary of the cavity, without the split segment
    std::vector<int> outside;  ///< half-edges across which triangles were added, on the outer side, in that order
    int segment = -1;          ///< the obstructing segment, if there is no cavity
    bool complete = false;
};

/// Starts with the triangle of `half_edge`, and adds the neighbour across every side that forms with p a triangle less
/// aligned than `least`. With `split` that half-edge is the segment on which p lies, and no side of the boundary.
InsertionCavity grow_cavity(const ClassifiedMesh& mesh, int half_edge, bool split, const Corner& p, double least);

}  // namespace mq::triangulate
