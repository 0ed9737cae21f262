// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "curve/volume/filling/filling.h"

namespace mq::curve {

/// Fills a closed, outward oriented surface by our own mesher (filling/surface_filling.h), and where that fails by
/// Netgen's, in a process of its own. All points and triangles of the surface are kept as they are.
/// @param grading_factor above 0: factor of the usual growth of tetrahedra away from the surface. 1 is the usual
/// growth; the smaller the factor, the more vertices lie inside.
/// @throws MeshingFailed when both fail, IoError when Netgen cannot be started; Cancelled.
TetrahedralFilling fill(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                        double grading_factor, const Progress& progress, const EndTangents& tangents = {});

}  // namespace mq::curve
