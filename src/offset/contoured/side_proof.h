// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.h"
#include "offset/contoured/distance_level_set.h"

namespace mq::offset {

using Tetrahedron = std::array<Vec3, 4>;

/// Proves that a tetrahedron lies inside of an offset, or outside of it, up to a slack.
///
/// The distance from one triangle is a convex function of the point. So the largest distance of a tetrahedron's corners
/// from a triangle is an upper bound for the distance of all its points from the surface; each triangle's tangent at
/// the middle gives a lower bound. If neither these bounds decide, nor the fact that distances change by no more than
/// the points' distance, the tetrahedron is divided.
class SideProof {
  public:
    /// @param slack  mm
    SideProof(const DistanceLevelSet& level_set, double slack) : level_set_(level_set), slack_(slack) {}

    /// Whether it is proven that no point is farther out than the slack; with `outside`, farther in.
    bool proves(const Tetrahedron& cell, bool outside, std::int32_t guess) const;

  private:
    struct Ball {
        Vec3 middle;
        double radius;
    };
    bool is_within(const Tetrahedron& cell, const Ball& ball, const contour::LevelSample& level) const;
    bool is_outside(const Tetrahedron& cell, const Ball& ball, const contour::LevelSample& level) const;
    bool is_farther_from_all(const Tetrahedron& cell, const Ball& ball, double least) const;
    bool proves(const Tetrahedron& cell, bool outside, std::int32_t guess, int divisions) const;

    const DistanceLevelSet& level_set_;
    const double slack_;
};

}  // namespace mq::offset
