// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/face_border.h"
#include "geometry/session.h"

namespace mq::geometry {

/// Where a surface comes to a point, a side of the parameter domain is one vertex. This divides such sides where the
/// surface turns along them, as around the apex of a cone, so that triangles at the apex find it beneath them in
/// (u, v): from the ends of the side they would reach half around the cone.
/// @return by site: the one that stands for it in the end. For those on such a side that is the one in its middle,
/// which has no normal; where the surface has normals at both ends of the side, the nearer end. Others stand for
/// themselves.
std::vector<int> divide_apexes(Session& session, int face, FaceBorder& border);

}  // namespace mq::geometry
