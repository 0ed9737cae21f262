// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/arrangement/soup.h"
#include "boolean/input/operation.h"
#include "mesh/intersection/self_intersection.h"

namespace mq::boolean {

struct NearCoincidence {
    std::size_t moved = 0;  ///< vertices
    double largest = 0.0;   ///< largest displacement of a vertex, mm
};

/// Whether surfaces of different operands nearly coincide: many crossings between nearly parallel triangles, over areas
/// and not only along curves.
/// @param few  a few crossings are enough; otherwise the slivers of a handful of triangles are accepted
bool nearly_coincident(const Soup& soup, const std::vector<mesh::ContactPair>& crossing, bool few);

/// Whether nearly coincident surfaces of any two operands are so near to each other that `separate` moves them.
bool separable(const Soup& soup, double tolerance, const std::vector<mesh::ContactPair>& crossing);

/// Where the surface of an operand nearly coincides with that of an operand before it, both cross each other again and
/// again, and the exact result has a multitude of slivers. This moves the later one's vertices there just below or
/// above the earlier one's surface, whichever leaves the earlier one's triangles whole (the rule of Remark 3 in Wang
/// 2010 for tangential contact, carried over to areas): in a union the later surface goes into the material of the
/// earlier one.
///
/// No vertex moves farther than `tolerance` (mm); where that is not enough nothing is moved. Nothing is moved for a
/// symmetric difference, whose slivers are the result.
/// @param crossing  some of the crossing pairs, from which the depth is estimated
NearCoincidence separate(Soup& soup, const Expression& expression, double tolerance,
                         const std::vector<mesh::ContactPair>& crossing, const Progress& progress);

/// Where faces of an operand are coplanar within rounding with those of an operand before it, the exact result has
/// skins and slivers of the rounding's thickness. This moves the later operand's faces there as `separate` does: by
/// `clearance` (mm) beyond the earlier one's, so that a hole's cap leaves no skin, and bodies in contact are joined.
NearCoincidence separate_coplanar(Soup& soup, const Expression& expression, const mesh::CoplanarPairs& flush,
                                  double clearance);

/// Puts vertices back where displacements left a triangle without area.
/// @param before  where the vertices were
void undo_degenerate_moves(Soup& soup, const std::vector<Vec3>& before);

}  // namespace mq::boolean
