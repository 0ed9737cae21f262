// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "boolean/soup.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// A result in the making.
struct Draft {
    std::vector<Vec3> vertices;
    std::vector<char> made;  ///< of each vertex: 1 constructed or moved here, 2 parted; 0 the operands' own
    std::vector<Triangle> triangles;
    std::vector<Source> source;  ///< of each triangle; operand -1 where it was made or changed here
    std::map<std::int32_t, std::vector<Vec3>> places;  ///< of parted vertices: where else they may be
    double largest_move = 0.0;                         ///< of a point from its exact place, mm
};

}  // namespace mq::boolean
