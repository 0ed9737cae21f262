// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "triangulate/operators/cavity.h"

namespace mq::triangulate {

/// Rules out fans by a disc's boundary: every spoke divides the corner in which it ends, and the regions that the sides
/// leave to an apex must have points in common. The test takes a fraction of the time of finding the best fan, and most
/// discs around a needle allow none.
class FanFeasibility {
  public:
    /// Prepares the test for fans whose angles are all at least `angle` (radians).
    FanFeasibility(const ClassifiedMesh& mesh, const Cavity& disc, double angle);

    /// Whether such a fan from a new vertex, between the lowest and the highest corner, is possible.
    bool allow_inner_apex() const;
    /// Returns a side of the boundary, by its index, that leaves other sides no place for such a vertex; -1: there is
    /// none, as far as can be told. It is the first one in the order of the boundary that does; growing across it may
    /// make room.
    int blocking_side() const { return blocking_side_; }
    /// Whether such a fan from the corner where side `k` of the boundary begins is possible.
    bool allow_apex(std::size_t k) const;

  private:
    double angle_;                     // radians
    int blocking_side_;                // index
    std::vector<double> angles_;       // by side: the angle inside the disc where the side begins, radians; 2 pi: wide
    std::vector<std::size_t> next_;    // by side: the side that begins where this one ends
    std::vector<std::size_t> before_;  // by side: the side that ends where this one begins
    std::vector<std::size_t> narrow_;  // corners whose angle cannot be divided by a spoke
};

}  // namespace mq::triangulate
