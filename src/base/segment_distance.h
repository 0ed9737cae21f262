// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>

#include "base/vec.h"

namespace mq {

/// The distance of p from the segment between a and b, which may be one point.
inline double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp(along.dot(p - a) / square, 0.0, 1.0) : 0.0;
    return (p - a - t * along).norm();
}

/// The distance between two segments, each of which may be one point (Ericson, Real-Time Collision Detection, section
/// 5.1.9).
inline double distance_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 one = b - a;
    const Vec3 two = d - c;
    const Vec3 apart = a - c;
    const double length_one = one.squaredNorm();
    const double length_two = two.squaredNorm();
    if (length_one == 0.0 || length_two == 0.0) {
        return length_one == 0.0 ? distance_to_segment(a, c, d) : distance_to_segment(c, a, b);
    }
    const double along_one = one.dot(apart);
    const double along_two = two.dot(apart);
    const double both = one.dot(two);
    const double determinant = length_one * length_two - both * both;
    const double s =
        determinant > 0.0 ? std::clamp((both * along_two - along_one * length_two) / determinant, 0.0, 1.0) : 0.0;
    const double t = std::clamp((both * s + along_two) / length_two, 0.0, 1.0);
    const double nearest = std::clamp((both * t - along_one) / length_one, 0.0, 1.0);
    return (apart + nearest * one - t * two).norm();
}

}  // namespace mq
