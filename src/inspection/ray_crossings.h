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
    bool leaves = false;  ///< the ray goes out of the solid: along the triangle's normal, not against it
};

/// All crossings of the ray with the triangles of the tree but `own`, on which it starts; nearest first, and of equally
/// near ones those that enter first.
///
/// The ray is the exact line through the origin and a point of double precision beyond the tree's box. Which triangles
/// it crosses is decided exactly: where it meets an edge or a vertex, or lies in a plane, the far point is taken as
/// moved by an infinitesimal vector (simulation of simplicity, Edelsbrunner and Mücke 1990), the same for all
/// triangles. A ray therefore crosses a closed surface an even number of times, its start counted; no edge lets it
/// through, and none counts twice.
/// @param direction  of length 1
std::vector<Crossing> crossings_of(const mesh::AabbTree& tree, const std::vector<Vec3>& vertices,
                                   const std::vector<mesh::Triangle>& triangles, const Vec3& origin,
                                   const Vec3& direction, std::int32_t own);

/// How often the surface winds around the points of the ray just after its origin.
int winding_at_start(const std::vector<Crossing>& crossings);

}  // namespace mq::inspection
