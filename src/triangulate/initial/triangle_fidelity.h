// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>

#include "base/angle.h"
#include "triangulate/initial/face_triangulator.h"

namespace mq::triangulate {

/// The reasons why a triangle does not represent its piece of the surface.
enum class TriangleFault {
    None,
    NormalDeviation,  ///< the normals of the triangle and of the surface deviate from each other
    /// The chord error is too large, or the triangle is upside down, because chords of the border are too long.
    ChordDeviation,
};

// A triangle is coarse if its normal and those of the surface at its corners and its centroid differ by more: 35
// degrees leave a margin below the 60 degrees that the refinement relies on.
const double kCosMaxTurn = std::cos(35.0 * kDegree);
// At the apex of a cone the normal deviates on every triangle, however small; there it only must not fold.
const double kCosMaxTurnAtApex = std::cos(70.0 * kDegree);

/// A triangle on a face, with the surface point over its centroid.
struct TriangleOnFace {
    std::array<const FaceMesh::VertexUse*, 3> corners;
    Vec3 on_surface;         ///< in the frame of the corners
    Vec3 surface_normal;     ///< at on_surface
    bool reversed;           ///< counter-clockwise in (u, v) is clockwise seen from outside
    double least_height;     ///< mm; lower triangles need not follow the surface
    double sag_that_counts;  ///< smallest chord error that matters, mm
};

TriangleFault fault_of(const TriangleOnFace& triangle);

}  // namespace mq::triangulate
