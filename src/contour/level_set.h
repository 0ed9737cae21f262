// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace mq::contour {

/// The value of a level set at a point, and the triangle that it comes from.
struct LevelSample {
    double value = 0.0;            ///< mm: negative inside, positive outside
    Vec3 gradient = Vec3::Zero();  ///< its length is 1
    std::int32_t source = -1;      ///< the input's triangle that the value comes from
};

/// A function of space whose zero set is a surface. Its values at two points differ by at most the distance between the
/// points.
class LevelSet {
  public:
    LevelSet() = default;
    LevelSet(const LevelSet&) = delete;
    LevelSet& operator=(const LevelSet&) = delete;
    virtual ~LevelSet() = default;

    /// @param guess  a triangle near the one that the value comes from makes the search faster; -1: none is known
    virtual LevelSample at(const Vec3& point, std::int32_t guess) const = 0;
    /// The patch of a source triangle.
    virtual std::int32_t patch(std::int32_t source) const = 0;
    /// mm: the zero set is nowhere bent outward more than a ball of this radius.
    virtual double least_radius() const = 0;
    /// mm: values up to this size count as 0.
    virtual double resolution() const = 0;
};

}  // namespace mq::contour
