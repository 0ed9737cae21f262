// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>

#include "base/vec.h"

namespace mq::curve {

/// A point in which the segment pq pierces a triangle, if every curve with the same ends pierces every disc as well
/// whose points are displaced by at most these distances (mm). While the segment is deformed into the curve and the
/// triangle into the disc their intersection number stays: no end of the curve meets the disc, and no border of the
/// disc meets the curve.
std::optional<Vec3> certain_piercing(const Vec3& p, const Vec3& q, double curve_bend,
                                     const std::array<Vec3, 3>& triangle, double disc_bend);

}  // namespace mq::curve
