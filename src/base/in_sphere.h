// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/vec.h"

namespace mq {

/// Positive when e lies inside the sphere through a, b, c, d, whose orient3d is positive; 0 on the sphere. Exact, as the
/// predicates of predicates.h are, for coordinates of magnitude 1e-15 to 1e15.
int in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace mq
