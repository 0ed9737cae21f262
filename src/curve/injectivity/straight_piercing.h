// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>

#include "base/vec.h"

namespace mq::curve {

/// A point where the segment pq pierces a triangle, if that holds as well for every curve with the same ends and every
/// disc whose points are displaced by at most these distances (mm). The curves and discs between them keep their
/// intersection number, as no end of a curve comes to the disc and no border of a disc to the curve.
std::optional<Vec3> certain_piercing(const Vec3& p, const Vec3& q, double curve_bend,
                                     const std::array<Vec3, 3>& triangle, double disc_bend);

}  // namespace mq::curve
