// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "elements/bezier/simplex_lattice.h"
#include "elements/product/element_kind.h"

namespace mq::elements {

/// A node by whole numbers, which are its coordinates on the reference element times the order: from 0 to the order,
/// but on pyramids x and y go from z - order to order - z in steps of two.
using GridPoint = std::array<int, 3>;

/// The edges and faces of an element by its corners, as Gmsh orders the nodes on them; faces of solids look outward.
struct ElementSides {
    std::vector<std::array<std::size_t, 2>> edges;
    std::vector<std::vector<std::size_t>> faces;
};
const ElementSides& sides_of(ElementKind kind);

/// All nodes of an element in Gmsh's order: corners, edges in their direction, faces, and then the inside; faces and
/// the inside each as an element of lower order. @throws InvalidInput for orders out of 1 to kMaxOrder.
std::vector<GridPoint> gmsh_nodes(ElementKind kind, int order);

/// Gmsh's order of the nodes of a line, triangle or tetrahedron of any order: entry i is the lattice point of node i.
const std::vector<int>& gmsh_order(const Lattice& lattice);
/// The control points of a line, triangle or tetrahedron from its nodes in Gmsh's order, and back.
std::vector<Vec3> gmsh_to_bezier(const Lattice& lattice, const std::vector<Vec3>& nodes);
std::vector<Vec3> bezier_to_gmsh(const Lattice& lattice, const std::vector<Vec3>& control);
/// VTK's order for its Lagrange cells; for order 2 also that of its quadratic cells.
std::vector<int> vtk_order(const Lattice& lattice);

/// The places of all nodes in Gmsh's order and on Gmsh's reference element: simplices and the triangles of prisms from
/// 0 to 1, lines, quadrilaterals and hexahedra from -1 to 1, pyramids over [-1, 1] x [-1, 1] with their apex at z = 1.
/// The nodes of serendipity elements are the first of them. @throws InvalidInput for orders that are not supported.
std::vector<Vec3> reference_nodes(ElementKind kind, int order);

}  // namespace mq::elements
