// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <memory>

#include "base/expansion.h"
#include "base/vec.h"

namespace mq::boolean {

/// A plane through three given points that are not collinear.
using PlanePoints = std::array<Vec3, 3>;

/// The plane through a line that is parallel to the axis; the line is not.
PlanePoints standing_plane(const Vec3& from, const Vec3& to, int axis);

/// A point known exactly: one that was given, or one constructed as the intersection of lines and planes through given
/// points. Constructed points are held as homogeneous coordinates of exact expansions beside the nearest doubles, so
/// that predicates first try the doubles (a static filter) and nearly never need more.
class ExactPoint {
  public:
    explicit ExactPoint(const Vec3& given) : approx_(given) {}

    /// Where the line through p and q meets the plane; p and q do not lie at the same signed distance from it.
    static ExactPoint on_line(const Vec3& p, const Vec3& q, const PlanePoints& plane);
    /// Where three planes in general position meet.
    static ExactPoint on_planes(const PlanePoints& a, const PlanePoints& b, const PlanePoints& c);

    /// Within error() of the point in each coordinate.
    const Vec3& approx() const { return approx_; }
    double error() const { return error_; }
    bool given() const { return exact_ == nullptr; }

    /// (x, y, z, w); w is not zero.
    std::array<Expansion, 4> homogeneous() const;

  private:
    explicit ExactPoint(std::array<Expansion, 4>&& exact);

    Vec3 approx_;
    double error_ = 0.0;
    std::shared_ptr<const std::array<Expansion, 4>> exact_;
};

/// Sign of p - q along a coordinate axis (0 x, 1 y, 2 z). Exact.
int compare(const ExactPoint& p, const ExactPoint& q, int axis);

/// Whether the two are the same point of space. Exact.
bool coincide(const ExactPoint& p, const ExactPoint& q);

/// Sign of the area of (p, q, r) seen against the axis, in the plane of the axes (axis + 1, axis + 2). Exact.
int orient2d(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r, int axis);

/// mq::orient3d for exact points.
int orient3d(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r, const ExactPoint& s);

}  // namespace mq::boolean
