// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/triangle_mesh.h"

namespace mq::inspection {

/// A ball that touches the surface at a point, and is as large as fits.
struct LargestBall {
    double radius = 0.0;  ///< mm; infinite where nothing limits it
    Vec3 center = Vec3::Zero();
    Vec3 contact = Vec3::Zero();  ///< the point of the surface that limits it
    std::int32_t triangle = -1;   ///< the triangle of that point; -1: nothing limits it
};

/// The balls found last that are free of the surface. Neighbouring points of round solids have nearly the same largest
/// ball, from whose centre all of the surface is equally far: the search for the nearest point is then slow, and needed
/// once only. It makes no difference to what is found.
class FreeBalls {
  public:
    /// Whether a ball lies in one of them.
    bool contain(const Vec3& center, double radius) const;
    void add(const Vec3& center, double radius);

  private:
    struct Ball {
        Vec3 center = Vec3::Zero();
        double radius = 0.0;
    };
    std::array<Ball, 8> balls_{};
    std::size_t next_ = 0;
};

/// The largest ball with its centre on the ray from `point` along `direction` that touches the surface in that point
/// and has none of it inside (the shrinking ball of Ma, Bae and Choi 2012; the nearest point is searched on the
/// triangles themselves, not among samples). It shrinks from a ball that is too large until it fits: each point found
/// inside gives the radius of the ball that touches there. What lies inside by less than `allowance` is let be, so that
/// the facets around the point do not count; at most a fifth of the radius there, and a fiftieth elsewhere.
/// @param direction  of length 1
/// @param ahead  the distance along the ray to the surface, and the triangle there; infinite and -1 where it meets
///     nothing. Twice the size of the surface then bounds the search: larger balls are infinite.
/// @param known  free balls of this surface; those found are added
LargestBall largest_ball(const mesh::NearestTree& tree, const Vec3& point, const Vec3& direction, double allowance,
                         double ahead, std::int32_t triangle_ahead, FreeBalls& known);

/// Where a ball touches the other side of a wall.
struct OppositeContact {
    std::int32_t triangle = -1;  ///< -1: nowhere
    double distance = 0.0;       ///< from the centre, mm
};

/// The nearest of the triangles that the ball touches, within a fiftieth of its radius, opposite to the point where it
/// starts: seen from the centre within `angle` (radians) of `direction`. The one that limits the ball if that is one.
OppositeContact opposite_contact(const mesh::NearestTree& tree, const std::vector<Vec3>& vertices,
                                 const std::vector<mesh::Triangle>& triangles, const LargestBall& ball,
                                 const Vec3& direction, double angle);

}  // namespace mq::inspection
