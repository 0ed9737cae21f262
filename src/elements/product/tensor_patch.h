// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "elements/bezier/bernstein.h"

/// Curved quadrilaterals as Bezier triangles.
namespace mq::elements {

/// The tensor-product control points of a quadrilateral: those of row i along its first side are entries i (order + 1)
/// and on.
/// @param given  its nodes in Gmsh's order, see all_nodes()
std::vector<Vec3> tensor_control(int order, const std::vector<Vec3>& given);

/// The two halves of the quadrilateral, on its corners 0, 1, 2 and 0, 2, 3: Bezier triangles of twice its order,
/// exactly (Goldman and Filip 1987). Their control points are means of those of the quadrilateral with positive
/// weights.
std::array<std::vector<Vec3>, 2> halves_of_quadrilateral(int order, const std::vector<Vec3>& control);

}  // namespace mq::elements
