// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/fold.h"

namespace mq::triangulate {

/// The triangles that must give way so that a new vertex p sees the whole rim around it without folds.
struct Cavity {
    std::vector<int> triangles;
    std::vector<int> rim;      ///< half-edges of these triangles on the border of the cavity, without the split segment
    std::vector<int> outside;  ///< half-edges across which triangles were taken in, on the outer side, in that order
    int segment = -1;          ///< that stands in the way, where there is no cavity
    bool complete = false;
};

/// Starts from the triangle of `half_edge` and takes in the neighbour across every side that makes with p a triangle
/// less aligned than `least`. With `split` that half-edge is the segment which p is put on, and no side of the rim.
Cavity grow_cavity(const mesh::SurfaceMesh& mesh, int half_edge, bool split, const Corner& p, double least);

}  // namespace mq::triangulate
