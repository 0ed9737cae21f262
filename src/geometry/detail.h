// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/angle.h"

namespace mq::geometry {

/// The detail (Topology::detail), where nothing else is said, as a fraction of the distance or the edges asked for.
constexpr double kDetailOfWhatIsAsked = 0.1;

/// Bounds on the corners that remain after details (Topology::detail) are contracted.
struct DetailCorners {
    /// Radians: least angle between the edges or faces that meet once a detail is contracted. Above the bounds that are
    /// usually asked for, so that no corner is made that cannot keep them.
    static constexpr double kLeastAngle = 30.0 * kDegree;
    /// Radians: least angle between faces that meet along a joined edge only: their triangles share it, and open from
    /// there.
    static constexpr double kLeastDihedral = 0.5 * kDegree;
    /// Distance from a contracted edge at which its neighbours are compared, in lengths of detail.
    static constexpr double kReach = 8.0;
};

}  // namespace mq::geometry
