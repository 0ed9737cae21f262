// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

#include "base/vec.h"

namespace mq {

constexpr double kDegree = M_PI / 180.0;  ///< radians in a degree

/// The angle between two directions, 0 to pi; accurate for small angles and nearly opposite directions too. 0 where one
/// of them is zero.
inline double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace mq
