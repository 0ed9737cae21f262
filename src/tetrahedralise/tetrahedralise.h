// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/progress.h"
#include "base/sizes/size_field.h"
#include "tetrahedralise/cells/tetrahedra.h"

namespace mq::tetrahedralise {

/// The sizes of tetrahedra away from the surface.
struct Grading {
    double factor = 1.0;               ///< above 0: factor of their usual growth; the smaller, the more vertices inside
    const SizeField* field = nullptr;  ///< bounds them; null: none
};

/// Divides the inside of a closed, outward oriented surface, which may have several shells and voids, into tetrahedra:
/// a Delaunay tetrahedralisation of its points, recovery of the surface, points inside, optimisation. Deterministic;
/// the result is checked exactly. The surface may touch itself at vertices and along edges.
/// All points and triangles of the surface are kept as they are.
/// @param tangents of the edges of the surface that will be curved: cells are made for those
/// @throws MeshingFailed where the surface is not closed, intersects itself or cannot be recovered; Cancelled.
Tetrahedra tetrahedralise(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                          const Grading& grading, const Progress& progress, const EndTangents& tangents = {});

}  // namespace mq::tetrahedralise
