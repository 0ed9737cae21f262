// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/triangle_mesh.h"

namespace mq::inspection {

/// A place where a ray crosses the surface.
struct Crossing {
    double distance = 0.0;  ///< from the ray's origin, mm
    std::int32_t triangle = -1;
    bool leaves =
        false;  ///< whether the ray leaves the solid there: it runs along the triangle's normal, not against it
};

/// All crossings of a ray with the triangles of the tree except `own`, on which the ray starts; nearest first. Of
/// equally near crossings those come first at which the ray enters the solid.
///
/// The ray is the exact segment from the origin to a point of double precision beyond the tree's box. The triangles
/// that it crosses are decided exactly. If it meets an edge or a vertex, or lies in a plane, the far point is taken as
/// moved by an infinitesimal vector (simulation of simplicity, Edelsbrunner and Mücke 1990), the same one for all
/// triangles. A ray therefore crosses a closed surface an even number of times, its start counted; it cannot slip
/// through an edge, and no crossing counts twice.
/// @param direction  of length 1
std::vector<Crossing> crossings_of(const mesh::AabbTree& tree, const std::vector<Vec3>& vertices,
                                   const std::vector<mesh::Triangle>& triangles, const Vec3& origin,
                                   const Vec3& direction, std::int32_t own);

/// The winding number of the surface around the points of the ray just after its origin.
int winding_at_start(const std::vector<Crossing>& crossings);

}  // namespace mq::inspection
