// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>

#include "base/vec.h"

namespace mq::triangulate {

/// A triangle in the parameters of a face with the places of its corners in space.
struct UvTriangle {
    std::array<Vec2, 3> uv;
    std::array<Vec3, 3> point;

    double longest_side() const {
        return std::max({(point[1] - point[0]).norm(), (point[2] - point[1]).norm(), (point[0] - point[2]).norm()});
    }
    /// (u, v) of the middle of side i, from corner i to the next.
    Vec2 middle(int i) const { return 0.5 * (uv[i] + uv[(i + 1) % 3]); }
    /// Those at the three corners, then the one between.
    /// @param middles  the places in space of the middles of the sides
    std::array<UvTriangle, 4> quarters(const std::array<Vec3, 3>& middles) const {
        std::array<UvTriangle, 4> found;
        for (int i = 0; i < 3; ++i) {
            const int before = (i + 2) % 3;
            found[i] = {{uv[i], middle(i), middle(before)}, {point[i], middles[i], middles[before]}};
        }
        found[3] = {{middle(0), middle(1), middle(2)}, middles};
        return found;
    }
};

}  // namespace mq::triangulate
