// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "elements/bezier/bernstein.h"

/// Inner control points of faces and regions from those of their boundary, for entities that are not on the CAD. The
/// centroid rule of Dey, O'Bara, Shephard 1999, section 5.4.3 (volume_editor.h), does not reproduce quadratics.
namespace mq::elements {

/// Sets the inner control points of a Bezier triangle by blending its edges: the linear map plus, for every edge, its
/// offset from straight carried inwards (Szabo and Babuska). Reproduces quadratics; straight edges give a straight
/// face.
void blend_triangle(const Lattice& lattice, std::vector<Vec3>& control);

/// Sets the inner control points of a Bezier tetrahedron of order 4, which all volumes have at most, from all others,
/// so that polynomials of one degree less are reproduced: the solution of least weights. From degree 4 on some
/// polynomials vanish on all faces, so that at higher orders the others do not determine the inner ones.
void blend_tetrahedron(const Lattice& lattice, std::vector<Vec3>& control);

/// Applies the chain rule to a derivative by all control points, of which the inner ones follow from the others: adds
/// the inner derivatives to those of the others, and sets them zero.
void spread_inner_gradient(const Lattice& lattice, std::vector<Vec3>& by_control);

}  // namespace mq::elements
