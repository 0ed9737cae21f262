// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boolean/arrangement.h"
#include "boolean/point_table.h"
#include "boolean/soup.h"
#include "boolean/triangle_pair.h"

namespace mq::boolean {

/// A piece of a divided plane: its points run as covers with turn +1 do.
struct DividedFace {
    std::array<std::int32_t, 3> points{};
    std::vector<Cover> covers;
};

/// The pieces of a triangle, or of several that overlap in one plane.
struct FaceDivision {
    std::vector<DividedFace> faces;
    /// Points where segments cross; they have the indices that follow the last one of the table.
    std::vector<ExactPoint> crossings;
};

/// Divides a triangle along what was found in it.
FaceDivision divide_triangle(const Soup& soup, std::int32_t triangle, const Incidences& found,
                             const PointTable& points);

/// Divides triangles of one plane together, so that where they overlap they have the same pieces.
FaceDivision divide_cluster(const Soup& soup, const std::vector<std::int32_t>& triangles, const Incidences& found,
                            const PointTable& points);

}  // namespace mq::boolean
