// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/draft.h"

namespace mq::boolean {

/// Puts the vertices that were made on single-precision numbers, which is what FreeCAD's Mesh kernel holds.
void round_to_single(Draft& draft);

/// What repair found and did.
struct RepairCount {
    std::size_t collapsed = 0;
    std::size_t flipped = 0;
    std::size_t moved = 0;
    std::size_t flakes = 0;            ///< components left out
    std::vector<std::int32_t> faulty;  ///< triangles of the draft that keep faults
};

/// Triangles that have no area, or touch or cross others, among those at parted vertices and what they meet.
std::size_t count_parting_faults(const Draft& draft, const Progress& progress);

/// Looks for degenerate triangles and self-intersections, which the rounding of made vertices causes, and removes them
/// by local changes next to made vertices: swapping an edge, collapsing one (not longer than `distance`, mm), or moving
/// a vertex by a few units in its last place. A change stays only if it leaves fewer faults around it.
/// The operands' own triangles change only where they share an edge or a vertex with a fault.
/// Components with faults that are thinner than single precision can tell apart are left out, as gaps and slabs thinner
/// than epsilon are in Wang 2010, section IV.B. Vertices that no triangle uses any more go, and `places` with them.
RepairCount repair(Draft& draft, double distance, const Progress& progress);

}  // namespace mq::boolean
