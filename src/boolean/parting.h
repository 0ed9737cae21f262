// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boolean/extraction.h"

namespace mq::boolean {

/// Where the copies of points in which parts of the result touch may go, so that the parts no longer touch.
///
/// All but the first copy of a point go into their own material: against the normals around them, or along their edges,
/// which stays within a thin wedge, of which the normals cancel each other. A thin wedge must be cut back far, so that
/// its sides stay apart in single precision; where other surfaces are near only little is allowed.
struct PartingPlan {
    std::vector<std::int32_t> copies;         ///< vertices of the draft that move
    std::vector<std::vector<Vec3>> variants;  ///< a place for each of them
};

/// @param distance  by how much to move at first, mm; variants try more and less, from `least` to `most`, and never
/// more than a part of the shortest edge
PartingPlan plan_parting(const Extraction& extraction, double distance, double least, double most);

/// Moves the copies, whose triangles then are no operand's own.
void move_copies(Draft& draft, const PartingPlan& plan, std::size_t variant);

}  // namespace mq::boolean
