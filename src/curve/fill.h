// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/progress.h"
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

/// Where the program lies that runs Netgen (netgen/fill_main.cpp). To be set once, before anything is filled.
void set_fill_program(const std::string& path);

/// Fills a closed, outward oriented surface by Netgen's nglib in a process of its own. All points and triangles of the
/// surface are kept as they are.
/// @param grading_part above 0: part of the usual growth of tetrahedra away from the surface. 1 is as usual; the less
/// it is, the more vertices lie inside.
/// @throws CannotFill when the mesher fails or crashes, GeometryError when it does not end, IoError when it cannot be
/// started; Cancelled.
Filling fill(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles, double grading_part,
             const Progress& progress);

}  // namespace mq::curve
