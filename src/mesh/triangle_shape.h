// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "base/vec.h"

namespace mq::mesh {

/// How good a triangle is by itself. Angles in degrees.
struct TriangleShape {
    double min_angle = 0.0;
    double max_angle = 0.0;
    double aspect = 0.0;  ///< longest edge / shortest edge; infinite for an edge without length
    /// Sum of the squared edges / (4 sqrt(3) area): 1 for 60 degrees everywhere, infinite when degenerate (the inverse
    /// of the mean ratio, see curve/distortion.h).
    double distortion = 0.0;
    double area = 0.0;        ///< mm^2; 0 when degenerate
    bool degenerate = false;  ///< two equal corners, or corners on one line
};

TriangleShape shape_of(const std::array<Vec3, 3>& corners);
/// TriangleShape::min_angle alone, in half the time.
double min_angle_of(const std::array<Vec3, 3>& corners);

}  // namespace mq::mesh
