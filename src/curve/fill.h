// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/error.h"
#include "base/vec.h"

namespace mq::curve {

/// A surface that cannot be filled, mostly because it meets itself: a finer one may do.
class CannotFill : public GeometryError {
    using GeometryError::GeometryError;
};

/// Tetrahedra inside a closed surface.
struct Filling {
    std::vector<Vec3> inner_points;              ///< numbered after the points of the surface
    std::vector<std::array<int, 4>> tetrahedra;  ///< positive volume
};

/// Fills a closed, outward oriented surface by Netgen's nglib. All points and triangles of the surface are kept as they
/// are. Netgen holds one mesh at a time for the whole process: calls wait for each other.
/// @throws CannotFill when the surface cannot be filled: it is not closed or meets itself.
Filling fill(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles);

}  // namespace mq::curve
