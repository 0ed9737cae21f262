// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/oracle.h"
#include "triangulate/initial/face_boundary.h"

namespace mq::triangulate {

/// If a surface has a singular point (an apex), a side of the parameter domain is a single vertex. This function
/// divides
/// such sides where the normal turns along them, as around the apex of a cone, so that triangles at the apex connect
/// to a nearby piece of the side in (u, v): triangles at the ends of the side would span half of the cone.
/// Also finds the collapsed runs of the border; the pieces of a divided side belong to one run.
/// @return by site: its final representative. For sites on a divided side this is the one in the middle, which has no
/// normal; where the surface has normals at both ends of the side, it is the nearer end. Other sites represent
/// themselves.
std::vector<int> divide_degenerate_sides(geometry::Oracle& oracle, int face, FaceBoundary& border);

}  // namespace mq::triangulate
