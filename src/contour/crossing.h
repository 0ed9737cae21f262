// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace mq::contour {

/// A point where a surface crosses an edge of a lattice between a node outside of it and a node that is not outside.
struct Crossing {
    Vec3 point = Vec3::Zero();     ///< on the edge, not at its ends
    Vec3 on_input = Vec3::Zero();  ///< a point of the plane that the surface has at the crossing
    Vec3 normal = Vec3::Zero();    ///< normal of that plane, outward, of length 1; zero if it closes a gap
    std::int32_t source = -1;      ///< the input's triangle that it belongs to; -1: it closes a gap
    std::int32_t patch = -1;  ///< patch of the input; cells with crossings of several patches get the border as an edge
};

/// The edges of a tetrahedron that a surface crosses, as the corners of a polygon that runs counter-clockwise seen from
/// outside. Consecutive ones are on edges of one of its faces.
struct CellPolygon {
    int count = 0;                                      ///< 0, 3 or 4
    std::array<std::array<std::int8_t, 2>, 4> edges{};  ///< the corners of each edge: the one outside first
};

/// @param corners  of a tetrahedron, in either orientation
CellPolygon cell_polygon(const std::array<Vec3, 4>& corners, const std::array<bool, 4>& is_outside);

/// A tetrahedron that a surface crosses.
struct CrossedCell {
    std::array<Vec3, 4> corners;
    CellPolygon polygon;
    std::array<std::int32_t, 4> crossings{-1, -1, -1, -1};  ///< the crossings at the corners of the polygon
};

struct CrossedCells {
    std::vector<CrossedCell> cells;
    std::vector<Crossing> crossings;
};

}  // namespace mq::contour
