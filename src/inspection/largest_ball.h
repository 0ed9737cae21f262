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

/// The largest ball that touches the surface at a given point and contains no other point of the surface.
struct LargestBall {
    double radius = 0.0;  ///< mm; infinite if nothing limits the ball
    Vec3 center = Vec3::Zero();
    Vec3 contact = Vec3::Zero();  ///< the point of the surface that limits the ball
    std::int32_t triangle = -1;   ///< the triangle of that point; -1: nothing limits the ball
};

/// The last balls that were found free of the surface. Neighbouring points of round solids have nearly the same largest
/// ball, all of whose surface is equally far from the centre, which makes the search for the nearest point slow; so it
/// is made only once. These balls do not change results.
class FreeBalls {
  public:
    /// Whether a ball lies inside of one of the free balls.
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

/// The largest ball with its centre on the ray from `point` along `direction` that touches the surface at that point
/// and contains none of it (the shrinking ball of Ma, Bae and Choi 2012; the nearest point is searched on the triangles
/// themselves, not among samples). The search starts with a ball that is too large and shrinks it: each point found
/// inside gives the radius of the ball that touches there. Points that lie inside by less than `allowance` (mm) are
/// ignored, so that the facets around `point` do not count; the allowance is at most a fifth of the radius near
/// `point`, and a fiftieth elsewhere.
/// @param direction  of length 1
/// @param ahead  the distance along the ray to the surface, and the triangle there; infinite and -1 if the ray meets
/// nothing. In that case twice the size of the surface bounds the search: larger balls are infinite.
/// @param known  free balls of this surface; new ones are added
LargestBall largest_ball(const mesh::NearestTree& tree, const Vec3& point, const Vec3& direction, double allowance,
                         double ahead, std::int32_t triangle_ahead, FreeBalls& known);

/// The point in which a ball touches the other side of a wall.
struct OppositeContact {
    std::int32_t triangle = -1;  ///< -1: there is no contact
    double distance = 0.0;       ///< mm: from the centre of the ball
};

/// The contact opposite to the point where the ball starts. It is the nearest triangle within a fiftieth of the radius
/// from the ball, in directions within `angle` (radians) of `direction` seen from the centre. The contact that stopped
/// the shrinking is preferred if it lies within `angle`.
OppositeContact opposite_contact(const mesh::NearestTree& tree, const std::vector<Vec3>& vertices,
                                 const std::vector<mesh::Triangle>& triangles, const LargestBall& ball,
                                 const Vec3& direction, double angle);

}  // namespace mq::inspection
