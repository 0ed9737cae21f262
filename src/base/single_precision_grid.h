// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/vec.h"

namespace mq {

/// Points that the Mesh kernel of FreeCAD stores without change: every coordinate is a single-precision number.
///
/// Coordinates are also multiples of 2^-48 of the model's size, so that differences of two of them are exact in double
/// precision and no predicate meets an underflow.
class SinglePrecisionGrid {
  public:
    /// @param box bounds the model, in its own coordinates. A model that lies far from the origin gets a local frame.
    explicit SinglePrecisionGrid(const Box& box);

    /// The origin of the local frame, in the model's coordinates; zero unless the model lies far away. Single precision
    /// too.
    const Vec3& origin() const { return origin_; }
    /// The nearest representable point, in the local frame.
    Vec3 snap(const Vec3& point_of_shape) const;
    /// Transforms a point from the local frame to the model's coordinates.
    Vec3 to_shape(const Vec3& local) const { return local + origin_; }
    /// The largest distance between a point of the model and its snapped image, mm.
    double resolution() const { return resolution_; }
    /// The length below which sides of triangles would collapse or make angles that are mostly rounding error, mm.
    double shortest_side() const { return 16.0 * resolution_; }

  private:
    Vec3 origin_ = Vec3::Zero();
    double quantum_ = 0.0;
    double resolution_ = 0.0;
};

}  // namespace mq
