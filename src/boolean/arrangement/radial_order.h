// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "boolean/arrangement/point_table.h"

namespace mq::boolean {

/// A face at an edge: its third point, whether the face runs along the edge from the low to the high end, and the
/// soup's triangle in whose plane it lies.
struct RadialFace {
    std::int32_t face = -1;
    std::int32_t apex = -1;
    bool runs_up = false;
    std::int32_t source = -1;
};

/// Sorts the faces at the edge from `low` to `high` counter-clockwise about that direction, exactly. No two of them
/// coincide. A face that runs up has its front on the counter-clockwise side. Planes are those of the soup's triangles:
/// predicates of given points are cheaper than those of constructed ones, most of all where planes coincide.
void sort_radially(const PointTable& points, std::int32_t low, std::int32_t high, std::vector<RadialFace>& faces);

}  // namespace mq::boolean
