// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/arrangement/point_table.h"
#include "boolean/arrangement/soup.h"

namespace mq::boolean {

/// A piece of the operands' surfaces that no other piece crosses.
struct Face {
    std::array<std::int32_t, 3> points{};  ///< indices into the point table, in the source's direction
    std::int32_t source = -1;              ///< triangle of the soup
    std::int32_t stack = -1;               ///< index into Arrangement::stacks where several triangles lie here
    bool whole = true;                     ///< whether the face is the whole source, not a piece of it
};

/// A triangle of the soup that covers a face, oriented as the face is (+1) or oppositely (-1).
struct CoplanarCover {
    std::int32_t triangle = -1;
    int turn = 1;
};

/// All operands' triangles divided along their common lines and points (mesh arrangement: Zhou, Grinspun, Zorin,
/// Jacobson 2016, section 3): faces meet in common edges and vertices only, exactly.
struct Arrangement {
    PointTable points;
    std::vector<Face> faces;
    std::vector<std::vector<CoplanarCover>> stacks;
};

/// @param crossing  pairs of triangles that may cross; pairs that only share vertices or edges do no harm
/// @throws Cancelled when `progress` says so
Arrangement arrange(const Soup& soup, const std::vector<CoincidentTriangle>& twins,
                    const std::vector<std::array<std::int32_t, 2>>& crossing, const Progress& progress);

}  // namespace mq::boolean
