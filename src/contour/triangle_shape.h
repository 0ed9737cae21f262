// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/vec.h"

namespace mq::contour {

/// The corners of a triangle.
using TriangleShape = std::array<Vec3, 3>;

inline Box box_of(const TriangleShape& c) {
    Box box;
    for (const Vec3& p : c) {
        box.add(p);
    }
    return box;
}

/// The square of the longest side.
inline double longest_square(const TriangleShape& c) {
    return std::max({(c[1] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm(), (c[0] - c[2]).squaredNorm()});
}

/// Tangent of the smallest angle. @param area  twice that of the triangle
inline double smallest_tangent(const TriangleShape& c, double area) {
    double cosine = 0.0;  // the largest cosine of an angle, times the lengths of its two sides
    for (std::size_t k = 0; k < 3; ++k) {
        cosine = std::max(cosine, (c[(k + 1) % 3] - c[k]).dot(c[(k + 2) % 3] - c[k]));
    }
    return area / cosine;
}

/// Twice the area, along the normal.
inline Vec3 cross(const TriangleShape& c) {
    return (c[1] - c[0]).cross(c[2] - c[0]);
}

}  // namespace mq::contour
