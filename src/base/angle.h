// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec.h"

namespace mq {

constexpr double kDegree = M_PI / 180.0;  ///< radians in a degree

/// The angle between two directions, 0 to pi; accurate for small angles and nearly opposite directions too. 0 where one
/// of them is zero.
inline double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Returns the squared sine of a triangle's smallest angle, which lies between the two longer sides, and is 60 degrees
/// at most. Several times as fast as the angle, tells small angles apart, which the cosine does not, and is sufficient
/// for comparisons. 0 if two corners coincide.
/// @param area  a normal as long as twice the area
/// @param a, b, c  squared lengths of the sides
inline double squared_sine_of_smallest_angle(const Vec3& area, double a, double b, double c) {
    const double product = a * b * c;
    return product > 0.0 ? area.squaredNorm() * std::min({a, b, c}) / product : 0.0;
}

/// The squared sine of the smallest angle of the triangle with corners `a`, `b`, `c`.
inline double squared_sine_of_smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 u = b - a;
    const Vec3 v = c - b;
    return squared_sine_of_smallest_angle(u.cross(v), u.squaredNorm(), v.squaredNorm(), (a - c).squaredNorm());
}

}  // namespace mq
