// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "elements/bezier/bernstein.h"
#include "elements/bezier/product_lattice.h"

/// Bezier elements: the maps x(xi) of Dey, O'Bara, Shephard 1999, section 2, and their Jacobians.
namespace mq::elements {

/// A Bernstein polynomial on a simplex or a product of simplices, with a bound on the rounding error of its
/// coefficients.
template <typename T>
struct BernsteinForm {
    const ProductLattice* lattice = nullptr;
    std::vector<T> coefficients;
    double rounding = 0.0;
    int exponent = 0;  ///< the value in the units of the nodes is that of the coefficients times 2 to this power
};
using JacobianForm = BernsteinForm<double>;
using NormalForm = BernsteinForm<Vec3>;

/// det(dx/dxi) of a Bezier tetrahedron of order q, equation (1), as a Bernstein polynomial of degree 3 (q - 1): the
/// box product of the three derivatives (equation (6)). Six times the volume where the element is straight.
JacobianForm jacobian_of(const Lattice& lattice, const std::vector<Vec3>& control);

/// jacobian_of() for an element stored by its nodes: `rounding` also bounds the effect of rounding the nodes to double
/// precision, so that J stays positive for whoever reads the nodes.
JacobianForm jacobian_by_nodes(const Lattice& lattice, const std::vector<Vec3>& control);

/// The Jacobian at one point.
double jacobian_at(const Lattice& lattice, const std::vector<Vec3>& control, const Barycentric& at);

/// The normal component (x_r x x_s) . n of a Bezier triangle of order q, where n is the polynomial of order q through
/// the outward unit normals of the CAD face at the element's nodes, in Bezier form: degree 3 q - 2. Positive
/// everywhere: the triangle does not fold over its face. Twice the area where triangle and face are flat.
JacobianForm normal_component(const Lattice& lattice, const std::vector<Vec3>& control,
                              const std::vector<Vec3>& cad_normals);

/// x_r x x_s of a Bezier triangle of order q: degree 2 (q - 1). Twice the area times the normal where it is flat.
NormalForm normal_of(const Lattice& lattice, const std::vector<Vec3>& control);

/// The sum of the squared derivatives along the directions of all edges of a Bezier triangle or tetrahedron of order q:
/// degree 2 (q - 1). The sum of the squared edges where the element is straight.
JacobianForm stretch_of(const Lattice& lattice, const std::vector<Vec3>& control);

}  // namespace mq::elements
