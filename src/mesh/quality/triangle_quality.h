// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>

#include "base/vec.h"

namespace mq::mesh {

/// The quality of a triangle by its shape. Angles in degrees.
struct TriangleShape {
    double min_angle = 0.0;
    double max_angle = 0.0;
    double aspect = 0.0;  ///< longest edge / shortest edge; infinite for an edge without length
    /// Sum of the squared edges / (4 sqrt(3) area): 1 for 60 degrees everywhere, infinite when degenerate (the inverse
    /// of the mean ratio, see curve/distortion.h).
    double distortion = 0.0;
    double area = 0.0;        ///< area, mm^2; 0 when degenerate
    bool degenerate = false;  ///< two equal corners, or corners on one line
};

TriangleShape shape_of(const std::array<Vec3, 3>& corners);
/// TriangleShape::min_angle alone, in half the time.
double min_angle_of(const std::array<Vec3, 3>& corners);

/// The unit normal of a triangle; zero where its height is below 1e-3 of its longest edge, as the normal is mostly
/// rounding then.
inline Vec3 robust_normal(const std::array<Vec3, 3>& p) {
    /// Least height as a fraction of the longest edge.
    constexpr double kThin = 1e-3;
    const Vec3 u = p[1] - p[0];
    const Vec3 v = p[2] - p[0];
    const Vec3 n = u.cross(v);
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    return n.norm() > kThin * longest ? Vec3(n.normalized()) : Vec3(Vec3::Zero());
}

}  // namespace mq::mesh
