// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// The ways in which two triangles of a mesh meet, apart from the vertices and the edge that they share by index.
enum class Contact {
    None,      ///< nowhere else
    Touching,  ///< somewhere else, but not with their interiors
    Crossing,  ///< their interiors have points in common: they pierce each other, or overlap in one plane
};

/// Exact. Corners of equal coordinates but different index are not shared. A triangle without area meets nothing.
/// (The test for interiors is that of Guigue and Devillers 2003.)
Contact contact(const std::vector<Vec3>& vertices, const Triangle& p, const Triangle& q);

/// Whether it is certain that two triangles have no point in common: their corners are separated along one of seven
/// directions in or across the plane of the first, with a margin for rounding. False means undecided.
bool certainly_apart(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& q);

}  // namespace mq::mesh
