// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace mq::contour {

/// What a level set is at a point.
struct LevelSample {
    double value = 0.0;            ///< mm: below 0 within, above it outside
    Vec3 gradient = Vec3::Zero();  ///< its length is 1
    std::int32_t source = -1;      ///< the input's triangle that decides
};

/// A function of space of which a surface is where it is 0. Its values at two points differ by at most
/// the distance of these.
class LevelSet {
  public:
    LevelSet() = default;
    LevelSet(const LevelSet&) = delete;
    LevelSet& operator=(const LevelSet&) = delete;
    virtual ~LevelSet() = default;

    /// @param guess  a triangle near the one that decides makes it faster; -1: none is known
    virtual LevelSample at(const Vec3& point, std::int32_t guess) const = 0;
    /// The patch of a source.
    virtual std::int32_t patch(std::int32_t source) const = 0;
    /// mm: the zero set is nowhere bent outward more than a ball of this radius.
    virtual double least_radius() const = 0;
    /// mm: values as small count as 0.
    virtual double resolution() const = 0;
};

}  // namespace mq::contour
