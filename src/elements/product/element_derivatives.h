// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/vec.h"
#include "elements/bezier/product_lattice.h"
#include "elements/product/element_kind.h"

namespace mq::elements {

using ExtendedMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// A polynomial that is linear in an element's nodes: its Bernstein coefficients are `from_nodes` times the nodes.
struct NodalPolynomial {
    ProductLattice lattice;
    ExtendedMatrix from_nodes;
};

/// The derivatives of the map from the domain of the kind to an element, whose box product is J.
///
/// Elements live on products of simplices: quadrilaterals and hexahedra on those of lines, prisms on that of a triangle
/// and a line. Pyramids live on the cube of (u, v, z) with x = u (1 - z), y = v (1 - z), where the space of order p
/// (Bergot, Cohen, Durufle 2010, which is Gmsh's) is spanned by
///     B(k, p, z) B(i, p - k, u) B(j, p - k, v),  0 <= k <= p,  0 <= i, j <= p - k,
/// B(i, n, t) being Bernstein's polynomials. Derivatives by u and v have the factor 1 - z; the determinant of these
/// two, divided by 1 - z, and of the derivative by z is that of the map from the pyramid. So J is a polynomial in u, v
/// and z of degrees
/// 3 p - 1, 3 p - 1 and 3 p - 3, which at the apex has a value for each direction in which one leaves it.
///
/// @param nodes  as many as an element has: all of them, or those of a serendipity element. Its space is the
///               subspace in which the inner nodes follow from the others, so that it is completed exactly.
/// @throws InvalidInput where elements of this kind and order have another number of nodes
std::vector<NodalPolynomial> derivatives_of(ElementKind kind, int order, int nodes);

/// All nodes of an element, whose inner ones follow from the others where it is a serendipity element.
/// @throws InvalidInput where elements of this kind and order have another number of nodes
std::vector<Vec3> all_nodes(ElementKind kind, int order, const std::vector<Vec3>& nodes);

}  // namespace mq::elements
