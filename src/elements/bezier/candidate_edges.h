// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "elements/bezier/bernstein.h"

/// The locality rules of Dey, O'Bara, Shephard 1999, section 5.2: which edges make an element invalid.
namespace mq::elements {

/// The edges of a tetrahedron in the order (0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3).
using CandidateEdges = std::array<bool, 6>;

/// Samples J at the corners, the middles of edges and faces, and the centroid. Where it is not positive at a corner,
/// the edges there are candidates for modification; on an edge, those with one of its ends; on a face or inside, all.
/// The result is the union over all samples. The rules were found for quadratics and hold for every order: J at a
/// corner depends on the first control points of the edges there, and on an edge only on the control points next to it.
CandidateEdges candidate_edges(const Lattice& lattice, const std::vector<Vec3>& control);

}  // namespace mq::elements
