// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "boolean/arrangement/soup.h"
#include "boolean/input/operation.h"
#include "boolean/near_coincidence/contact_regions.h"

namespace mq::boolean {

struct NearCoincidence {
    std::size_t moved = 0;  ///< vertices
    double largest = 0.0;   ///< largest displacement of a vertex, mm
};

struct OverlapOptions {
    /// mm, the largest displacement; twice this where it joins or separates bodies, as in a corner of three faces
    double tolerance = 0.0;
    /// mm: distance by which a common face of the later operand is moved beyond that of the earlier one; larger than
    /// the moves of rounding
    double clearance = 0.0;
};

/// Whether these triangles lie on each other within the tolerance only, and not exactly.
bool differs(const ContactFace& face);

/// Moves faces that nearly coincide so that they no longer cross: the vertices of the later operand move beyond the
/// faces of the earlier one, to the side that keeps these faces whole in the result (the rule of Remark 3 in Wang 2010
/// for tangential contact, for areas). In a union they move into the material of the earlier operand, which joins the
/// bodies without a film; in an intersection and a difference, out of it.
///
/// The displacement of a vertex is the shortest one beyond the planes of all faces on which its triangles lie, each by
/// the distance that the pair needs: a quadratic programme in three variables. Planes of other faces are no constraint,
/// so that the sides of a body stay while its base moves along them, unless they belong to the common face or are
/// coplanar with a triangle that meets them after the move. If not all constraints can be met, those that join or
/// separate bodies come first. A vertex whose displacement would be longer than the tolerance allows stays.
///
/// Faces that coincide exactly are left alone, unless a vertex of them moves: the arrangement knows them. Nothing is
/// moved for a symmetric difference.
/// @param search, contacts  of the soup
NearCoincidence overlap_contacts(Soup& soup, const FacingSearch& search, const Expression& expression,
                                 const std::vector<ContactFace>& contacts, const OverlapOptions& options,
                                 const Progress& progress);

/// Puts vertices back where displacements left a triangle without area.
/// @param before  positions of the vertices before the displacements
void undo_degenerate_moves(Soup& soup, const std::vector<Vec3>& before);

}  // namespace mq::boolean
