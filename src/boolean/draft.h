// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boolean/soup.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// A result in the making.
struct Draft {
    std::vector<Vec3> vertices;
    std::vector<char> made;  ///< of each vertex: constructed or moved here; the others are the operands' own
    std::vector<Triangle> triangles;
    std::vector<Source> source;  ///< of each triangle; operand -1 where it was made or changed here
    std::size_t parted = 0;      ///< vertices at which bodies that touched were parted
    double largest_move = 0.0;   ///< of a point from its exact place, mm
};

}  // namespace mq::boolean
