// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/error.h"
#include "base/vec.h"
#include "tetrahedralise/cells/end_tangents.h"

namespace mq::tetrahedralise {

/// A surface that cannot be tetrahedralised, mostly because it intersects itself: a finer one may be tetrahedralised.
class MeshingFailed : public GeometryError {
    using GeometryError::GeometryError;
};

/// Tetrahedra inside a closed surface.
struct Tetrahedra {
    std::vector<Vec3> inner_points;              ///< numbered after the points of the surface
    std::vector<std::array<int, 4>> tetrahedra;  ///< positive volume
};

}  // namespace mq::tetrahedralise
