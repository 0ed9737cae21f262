// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/vec.h"

namespace mq {

/// Points that the Mesh kernel of FreeCAD stores without change: every coordinate is a single-precision number.
///
/// Coordinates are also multiples of 2^-48 of the part's size, so that differences of two of them are exact in double
/// precision and no predicate meets an underflow.
class SingleGrid {
  public:
    /// `box` bounds the part, in its own coordinates. A part that lies far from the origin gets a local frame.
    explicit SingleGrid(const Box& box);

    /// Of the local frame, in the part's coordinates; zero unless the part lies far away. Single precision too.
    const Vec3& origin() const { return origin_; }
    /// The nearest representable point, in the local frame.
    Vec3 snap(const Vec3& point_of_part) const;
    /// From the local frame to the part's coordinates.
    Vec3 to_part(const Vec3& local) const { return local + origin_; }
    /// The largest distance between a point of the part and its snapped image, mm.
    double resolution() const { return resolution_; }
    /// Sides of triangles shorter than this, mm, would fall together or make angles that are mostly rounding.
    double shortest_side() const { return 16.0 * resolution_; }

  private:
    Vec3 origin_ = Vec3::Zero();
    double quantum_ = 0.0;
    double resolution_ = 0.0;
};

}  // namespace mq
