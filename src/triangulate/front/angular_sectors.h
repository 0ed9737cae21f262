// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/vec.h"

namespace mq::triangulate {

/// Stores the sectors of directions around a vertex, projected along its normal, that triangles or the outside of the
/// face occupy already.
class AngularSectors {
  public:
    explicit AngularSectors(const Vec3& normal);

    /// Returns the counter-clockwise angle of a direction in radians; the direction must not be along the normal.
    double angle_of(const Vec3& direction) const;
    /// Whether the counter-clockwise sector between two directions is narrower than half a turn and unoccupied.
    bool free(double from, double to) const;
    /// Occupies the sector; two equal directions mark a cut (an edge with the face on both sides), not a full turn.
    void occupy(double from, double to) { occupied_.push_back({from, turn(from, to)}); }

    /// Returns the counter-clockwise angle between two directions, in [0, 2 pi).
    static double turn(double from, double to);

  private:
    struct Sector {
        double from;
        double width;
    };
    Vec3 x_;
    Vec3 y_;
    std::vector<Sector> occupied_;
};

}  // namespace mq::triangulate
