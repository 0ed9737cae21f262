// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "curve/bezier/simplex_lattice.h"

/// Curved quadrilaterals as Bezier triangles.
namespace mq::curve {

/// The tensor-product control points of a quadrilateral: those of row i along its first side are entries i (order + 1)
/// and on.
/// @param nodes  in Gmsh's order: all of them, or the eight of a serendipity element of order 2, whose ninth follows
///               from them
std::vector<Vec3> tensor_control(int order, std::vector<Vec3> nodes);

/// The two halves of the quadrilateral, on its corners 0, 1, 2 and 0, 2, 3: Bezier triangles of twice its order,
/// exactly (Goldman and Filip 1987). Their control points are means of those of the quadrilateral with positive
/// weights.
std::array<std::vector<Vec3>, 2> halves_of_quadrilateral(int order, const std::vector<Vec3>& control);

/// The same triangle as one of a higher degree, exactly: each control point is a mean of some before.
std::vector<Vec3> raised_to(int degree, const Lattice& lattice, const std::vector<Vec3>& control);

}  // namespace mq::curve
