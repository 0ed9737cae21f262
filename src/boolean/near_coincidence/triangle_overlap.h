// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "base/vec.h"

namespace mq::boolean {

/// Heights of a triangle over the plane of another one, over the area in which they overlap along the plane's normal.
struct Overlap {
    double area = 0.0;   ///< mm2, where it is at most `reach` from the plane; 0: the triangles do not face each other
    double worst = 0.0;  ///< mm, the largest distance from the plane in that area
    /// Heights over the plane, also beyond the reach, mm.
    double low = 0.0;  ///< 0 to 0 where both triangles lie in one plane, exactly
    double high = 0.0;
    Box box;                 ///< contains the overlap
    bool same_side = false;  ///< the normals have the same direction
};

/// The overlap of triangle q with triangle p; none where their planes differ by more than 45 degrees.
/// @param reach   mm
/// @param margin  mm, by which p is larger on all sides
Overlap overlap_of(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& q, double reach, double margin = 0.0);

}  // namespace mq::boolean
