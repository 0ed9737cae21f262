// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.h"
#include "offset/distance_level_set.h"

namespace mq::offset {

using Tetrahedron = std::array<Vec3, 4>;

/// Whether all of a tetrahedron lies within an offset or outside of it, but for some slack.
///
/// The distance from one triangle is a convex function. So the largest distance of a tetrahedron's corners from one of
/// the triangles bounds that of all of its points from the surface from above; from below each triangle's tangent at
/// the middle bounds it. Where neither tells, nor that distances change by no more than points are apart, the
/// tetrahedron is divided.
class SideProof {
  public:
    /// @param slack  mm
    SideProof(const DistanceLevelSet& level_set, double slack) : level_set_(level_set), slack_(slack) {}

    /// Whether it is proven that no point is farther out than the slack (outside: farther in).
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
