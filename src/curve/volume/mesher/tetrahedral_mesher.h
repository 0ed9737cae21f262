// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/progress.h"
#include "base/vec.h"

namespace mq::curve {

/// A surface that cannot be filled, mostly because it intersects itself: a finer one may be filled.
class MeshingFailed : public GeometryError {
    using GeometryError::GeometryError;
};

/// Tetrahedra inside a closed surface.
struct TetrahedralFilling {
    std::vector<Vec3> inner_points;              ///< numbered after the points of the surface
    std::vector<std::array<int, 4>> tetrahedra;  ///< positive volume
};

/// Sets the path of the program that runs Netgen (netgen/fill_main.cpp). To be called once, before anything is filled.
void set_fill_program(const std::string& path);

/// Fills a closed, outward oriented surface by Netgen's nglib in a process of its own. All points and triangles of the
/// surface are kept as they are.
/// @param grading_factor above 0: factor of the usual growth of tetrahedra away from the surface. 1 is the usual
/// growth; the smaller the factor, the more vertices lie inside.
/// @throws MeshingFailed when the mesher fails or crashes, GeometryError when it does not end, IoError when it cannot
/// be started; Cancelled.
TetrahedralFilling fill(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                        double grading_factor, const Progress& progress);

}  // namespace mq::curve
