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

}  // namespace mq
