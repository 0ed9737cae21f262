// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <memory>

#include "base/expansion.h"
#include "base/vec.h"

namespace mq::boolean {

/// A plane through three given points that are not collinear.
using PlanePoints = std::array<Vec3, 3>;

/// The plane that contains a line and is parallel to the axis; the line is not parallel to it.
PlanePoints standing_plane(const Vec3& from, const Vec3& to, int axis);

/// A point known exactly: a given one, or one constructed as the intersection of lines and planes through given points.
///
/// Predicates first try the nearest doubles with a static filter. Those of a constructed point come from its
/// construction in double-double arithmetic with a forward error bound; its homogeneous coordinates as exact expansions
/// are computed when a predicate first needs them, or at once where the bound does not suffice. A constructed point
/// whose coordinates are doubles, as for axis-parallel boxes, is kept as if it were given. Threads may share points.
class ExactPoint {
  public:
    explicit ExactPoint(const Vec3& given) : approx_(given) {}

    /// Where the line through p and q meets the plane; p and q do not lie at the same signed distance from it.
    static ExactPoint on_line(const Vec3& p, const Vec3& q, const PlanePoints& plane);
    /// Where three planes in general position meet.
    static ExactPoint on_planes(const PlanePoints& a, const PlanePoints& b, const PlanePoints& c);

    /// The nearest doubles; within error() of the point in each coordinate.
    const Vec3& approx() const { return approx_; }
    double error() const { return error_; }
    /// Whether the coordinates are doubles: approx() is the point itself.
    bool given() const { return construction_ == nullptr; }

    /// Whether both are constructed of the same three planes, as where each of three faces finds the point in which
    /// they meet: the points are the same, and nothing is computed.
    bool is_same_intersection(const ExactPoint& other) const;

    /// (x, y, z, w); w is not zero.
    std::array<Expansion, 4> homogeneous() const;

  private:
    class Construction;

    explicit ExactPoint(std::shared_ptr<const Construction> construction);

    Vec3 approx_;
    double error_ = 0.0;
    std::shared_ptr<const Construction> construction_;
};

/// Sign of p - q along a coordinate axis (0 x, 1 y, 2 z). Exact.
int compare(const ExactPoint& p, const ExactPoint& q, int axis);

/// Whether the two are the same point of space. Exact.
bool coincide(const ExactPoint& p, const ExactPoint& q);

/// Sign of the area of (p, q, r) seen against the axis, in the plane of the axes (axis + 1, axis + 2). Exact.
int orient2d(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r, int axis);

/// mq::orient3d(plane[0], plane[1], plane[2], p): 1 where p lies on the side to which the plane's normal points, -1 on
/// the other. Exact.
int side_of(const PlanePoints& plane, const ExactPoint& p);

}  // namespace mq::boolean
