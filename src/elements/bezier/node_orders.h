// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "elements/bezier/simplex_lattice.h"

/// The order in which other programs list an element's nodes.
namespace mq::curve {

/// Gmsh's order of the nodes of a line, triangle or tetrahedron: entry i is the lattice point of Gmsh's node i.
/// Corners, edges in their direction, faces and then the inside, each inside as an element of lower order.
std::vector<int> gmsh_order(const Lattice& lattice);

/// VTK's order for its Lagrange cells; for order 2 also that of its quadratic cells.
std::vector<int> vtk_order(const Lattice& lattice);

}  // namespace mq::curve
