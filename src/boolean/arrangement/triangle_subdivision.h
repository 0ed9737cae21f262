// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/arrangement/arrangement.h"
#include "boolean/arrangement/point_table.h"
#include "boolean/arrangement/soup.h"
#include "boolean/arrangement/triangle_intersection.h"

namespace mq::boolean {

/// A piece of a divided plane: its points run in the direction of the covers with turn +1.
struct DividedFace {
    std::array<std::int32_t, 3> points{};
    std::vector<CoplanarCover> covers;
};

/// The pieces of a triangle, or of several that overlap in one plane.
struct FaceDivision {
    std::vector<DividedFace> faces;
    /// Points where segments cross; they have the indices that follow the last one of the table.
    std::vector<ExactPoint> crossings;
};

/// Divides a triangle along the points and segments found on it.
FaceDivision divide_triangle(const Soup& soup, std::int32_t triangle, const Incidences& found, const PointTable& points,
                             const Progress* progress);

/// Divides triangles of one plane together, so that they have the same pieces where they overlap.
FaceDivision divide_cluster(const Soup& soup, const std::vector<std::int32_t>& triangles, const Incidences& found,
                            const PointTable& points, const Progress* progress);

}  // namespace mq::boolean
