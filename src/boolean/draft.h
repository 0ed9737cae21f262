// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "boolean/soup.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// Of a vertex: the operands' own, constructed or moved here, or a copy that was parted from others.
constexpr char kOwn = 0;
constexpr char kMade = 1;
constexpr char kParted = 2;

/// A result in the making.
struct Draft {
    std::vector<Vec3> vertices;
    std::vector<char> made;  ///< of each vertex: kOwn, kMade or kParted
    std::vector<Triangle> triangles;
    std::vector<Source> source;      ///< of each triangle; operand -1 where it was made or changed here
    std::vector<std::int32_t> from;  ///< of each triangle: the soup's triangle of which it is a piece, or was
    std::map<std::int32_t, std::vector<Vec3>> places;  ///< of parted vertices: where else they may be
    double largest_move = 0.0;                         ///< of the surface from its exact place, mm: two-sided
};

/// What stands for a triangle that has been removed, until remove_gone.
constexpr Triangle kGone{-1, -1, -1};

inline bool gone(const Triangle& t) {
    return t[0] < 0;
}

void remove_gone(Draft& draft);

/// Removes vertices that no triangle uses, and all other places.
void remove_unused_vertices(Draft& draft);

}  // namespace mq::boolean
