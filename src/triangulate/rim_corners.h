// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "triangulate/disc.h"

namespace mq::triangulate {

/// The corners of a disc's rim, and which fans they leave no room for: every spoke halves the corner that it ends in.
/// Found in a fraction of the time that the best fan takes, and most discs around a needle have none.
class RimCorners {
  public:
    /// For fans whose angles are all to be `angle` (radians) at least.
    RimCorners(const mesh::SurfaceMesh& mesh, const Disc& disc, double angle);

    /// Whether there may be such a fan from a new vertex.
    bool allow_inner_apex() const;
    /// Whether there may be such a fan from the corner where side `k` of the rim begins.
    bool allow_apex(std::size_t k) const;

  private:
    double angle_;                     // radians
    std::vector<double> angles_;       // inside the disc, where the rim's sides begin, radians
    std::vector<std::size_t> next_;    // the side that begins where one ends
    std::vector<std::size_t> before_;  // and that ends where one begins
    std::vector<std::size_t> narrow_;  // corners without room for a spoke
};

}  // namespace mq::triangulate
