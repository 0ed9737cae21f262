// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "base/vec.h"
#include "triangulate/spacing/uv_outline.h"

namespace mq::triangulate {

/// Returns a uniform number in [0, 1) that is the same with every standard library.
inline double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Looks for points of a triangle that no ball covers.
///
/// Darts are thrown at the triangle; while they fail it is halved into ever smaller fragments, and covered fragments
/// receive no more darts (Ebeida, Mitchell, Patney, Davidson, Owens 2012). Two or three balls may cover a fragment
/// together, so that the borders between balls need few fragments.
class VoidSearch {
  public:
    struct Ball {
        Vec3 centre;
        double radius;  ///< mm; 0: the radius that holds at the place to be covered
    };

    /// The region of the triangle to be covered, in places: weights of the corners 1 and 2.
    struct Outline {
        std::vector<Segment2> segments;  ///< pieces of the outline that run through the triangle
        Vec2 reference;                  ///< a place in the triangle
        bool inside;                     ///< whether the reference place lies inside the outline
    };

    /// @param radii  mm, at the corners: the radii, linear in between, for balls that have none of their own
    VoidSearch(const std::array<Vec3, 3>& triangle, const std::array<double, 3>& radii, const std::vector<Ball>& balls,
               const Outline& outline);

    /// Returns a random place, evenly distributed over the inner region that no ball covers. Returns none once only
    /// fragments remain whose longest side is `least` (mm) or shorter.
    std::optional<Vec2> find(double least, std::mt19937_64& random);

  private:
    // A ball, projected onto the triangle's plane.
    struct Cavity {
        Vec2 centre;
        double height;  // squared distance of the ball's centre from the plane, mm^2
        double radius;  // radius of the ball, mm; 0 as in Ball
    };
    using Fragment = Triangle2;
    // The disc in which a ball meets the plane, if it holds corners of a fragment.
    struct Cover {
        Vec2 centre;
        double reach;      // squared radius of the disc, mm^2
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
    double size_ = 0.0;           // length of the longest side, mm; 0: the triangle has no area
    double radius_ = 0.0;         // radius at the plane's origin, mm
    Vec2 growth_ = Vec2::Zero();  // gradient of the radius over the plane
    Outline outline_;             // in coordinates of the plane, mm
    std::vector<Cavity> discs_;
    std::vector<Cover> covers_;  // the discs that hold corners of the present fragment
};

}  // namespace mq::triangulate
