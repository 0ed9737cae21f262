// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/operation.h"
#include "boolean/soup.h"
#include "mesh/self_intersection.h"

namespace mq::boolean {

struct NearCoincidence {
    std::size_t moved = 0;  ///< vertices
    double largest = 0.0;   ///< way that a vertex was moved, mm
};

/// Whether surfaces of different operands run along each other: many crossings between nearly parallel triangles, a
/// matter of areas and not of curves.
///
/// @param few  a few crossings are enough; otherwise the slivers of a handful of triangles are put up with
bool run_along(const Soup& soup, const std::vector<mesh::ContactPair>& crossing, bool few);

/// Where the surface of an operand runs along that of an operand before it, both weave through each other, and the
/// exact result is a multitude of slivers. This moves the later one's vertices there just below or above the earlier
/// one's surface, whichever leaves the earlier one's triangles whole (the rule of Remark 3 in Wang 2010 for tangential
/// contact, carried over to areas): in a union the later surface goes into the material of the earlier one.
///
/// No vertex moves farther than `tolerance` (mm); where that is not enough nothing is moved. Nothing is moved for a
/// symmetric difference, of which the slivers are the result.
/// @param crossing  some of the crossing pairs, from which the depth is estimated
NearCoincidence separate(Soup& soup, Operation operation, double tolerance,
                         const std::vector<mesh::ContactPair>& crossing, const Progress& progress);

/// Where faces of an operand are flush with those of an operand before it, but so only to within rounding, the exact
/// result has skins and slivers of that thickness. This moves the later operand's faces there as `separate` does: by
/// `clearance` (mm) beyond the earlier one's, so that a hole's cap leaves no skin, and bodies that lie on each other
/// hang together.
NearCoincidence separate_flush(Soup& soup, Operation operation, const mesh::FlushPairs& flush, double clearance);

}  // namespace mq::boolean
