// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>

#include "base/vec.h"

namespace mq::improve {

/// The unit normal of a triangle; zero where its height is below 1e-3 of its longest edge, as the normal is mostly
/// rounding then.
inline Vec3 sound_normal(const std::array<Vec3, 3>& p) {
    constexpr double kThin = 1e-3;
    const Vec3 u = p[1] - p[0];
    const Vec3 v = p[2] - p[0];
    const Vec3 n = u.cross(v);
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    return n.norm() > kThin * longest ? Vec3(n.normalized()) : Vec3(Vec3::Zero());
}

}  // namespace mq::improve
