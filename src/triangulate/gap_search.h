// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "base/vec.h"
#include "triangulate/uv_outline.h"

namespace mq::triangulate {

/// A uniform number in [0, 1), the same with every library.
inline double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Looks for points of a triangle that no ball covers.
///
/// Darts are thrown at the triangle; while they fail it is halved into ever smaller fragments, and those that are
/// covered get no more darts (Ebeida, Mitchell, Patney, Davidson, Owens 2012). Two or three balls may cover a fragment
/// together, so that the borders between balls need few of them.
class GapSearch {
  public:
    struct Ball {
        Vec3 centre;
        double radius;  ///< 0: that of the place which is to be covered
    };

    /// What of the triangle counts, in places: weights of the corners 1 and 2.
    struct Outline {
        std::vector<Segment2> segments;  ///< those in the triangle
        Vec2 reference;                  ///< a place in the triangle
        bool inside;                     ///< whether it is inside of the outline
    };

    /// @param radii  at the corners, of balls that have none of their own; linear in between
    GapSearch(const std::array<Vec3, 3>& triangle, const std::array<double, 3>& radii, const std::vector<Ball>& balls,
              const Outline& outline);

    /// A random place, evenly distributed over what is inside and not covered. None when all is covered but for
    /// fragments with no side longer than `least`.
    std::optional<Vec2> find(double least, std::mt19937_64& random);

  private:
    // A ball over the triangle's plane.
    struct Disc {
        Vec2 centre;
        double height;  // of the ball's centre, squared
        double radius;  // of the ball, 0 as above
    };
    using Fragment = Triangle2;
    // A disc in the plane that holds corners of a fragment.
    struct Cover {
        Vec2 centre;
        double reach;      // squared
        unsigned corners;  // bit i: corner i

        bool holds(const Vec2& p) const { return (p - centre).squaredNorm() < reach; }
    };

    double radius_at(const Vec2& p) const { return radius_ + growth_.dot(p); }
    Vec2 in_plane(const Vec2& place) const { return place.x() * whole_[1] + place.y() * whole_[2]; }
    bool inside(const Vec2& p) const;
    bool outside(const Fragment& fragment) const;
    bool free(const Vec2& p) const;
    bool covered(const Fragment& fragment);
    bool covered_by_two(const Fragment& fragment) const;
    bool covered_by_three(const Fragment& fragment) const;
    static double part_held(const Cover& cover, const Vec2& from, const Vec2& to);
    static bool hold_side(const Cover& a, const Vec2& from, const Cover& b, const Vec2& to);

    Fragment whole_;
    double size_ = 0.0;           // the longest side; 0: no area
    double radius_ = 0.0;         // at the plane's origin
    Vec2 growth_ = Vec2::Zero();  // of the radius
    Outline outline_;             // in the plane
    std::vector<Disc> discs_;
    std::vector<Cover> covers_;  // of the present fragment
};

}  // namespace mq::triangulate
