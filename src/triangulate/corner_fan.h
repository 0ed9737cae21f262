// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/vec.h"

namespace mq::triangulate {

/// The directions around a vertex, seen along its normal, that triangles or the outside of the face take up already.
class CornerFan {
  public:
    explicit CornerFan(const Vec3& normal);

    /// Counter-clockwise, radians; the direction must not be along the normal.
    double angle_of(const Vec3& direction) const;
    /// Whether the turn from one direction counter-clockwise to another is less than half a turn, and free.
    bool free(double from, double to) const;
    /// Takes the turn up; equal directions stand for nothing but a cut there.
    void take(double from, double to) { taken_.push_back({from, turn(from, to)}); }

    /// From one angle counter-clockwise to another, in [0, 2 pi).
    static double turn(double from, double to);

  private:
    struct Sector {
        double from;
        double width;
    };
    Vec3 x_;
    Vec3 y_;
    std::vector<Sector> taken_;
};

}  // namespace mq::triangulate
