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
    /// mm, the largest displacement; twice this where it joins or parts bodies, as in a corner of three faces
    double tolerance = 0.0;
    /// mm: distance by which a common face of the later operand is moved beyond that of the earlier one; larger than
    /// the moves of rounding
    double clearance = 0.0;
};

/// Whether these triangles lie on each other within the tolerance only, and not exactly.
bool differs(const ContactFace& face);

/// Makes of faces that nearly coincide such as cross nowhere: the vertices of the later operand's move beyond the faces
/// of the earlier one, whichever way leaves these whole (the rule of Remark 3 in Wang 2010 for tangential contact, for
/// areas). In a union they go into the material of the earlier operand, so that the bodies are joined and no film is
/// left between them; in an intersection and a difference, out of it.
///
/// A vertex takes the shortest way that leaves the planes of all faces on which its triangles lie, each by as much as
/// the pair needs: a quadratic programme in three variables. Planes of other faces are no constraint, so that a side of
/// a body stays in its place while its base is moved along it; but planes of the common face, or in one plane with the
/// triangle, on which it lies only after the move are left as well. Where not all can be left, those that join or part
/// bodies come first. A vertex whose way is longer than the tolerance allows stays.
///
/// Faces that coincide exactly are left alone, unless a vertex of them moves: the arrangement knows them. Nothing is
/// moved for a symmetric difference.
/// @param search, contacts  of the soup
NearCoincidence overlap_contacts(Soup& soup, const FacingSearch& search, const Expression& expression,
                                 const std::vector<ContactFace>& contacts, const OverlapOptions& options,
                                 const Progress& progress);

/// Puts vertices back where displacements left a triangle without area.
/// @param before  where the vertices were
void undo_degenerate_moves(Soup& soup, const std::vector<Vec3>& before);

}  // namespace mq::boolean
