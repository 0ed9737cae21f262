// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>

#include "base/angle.h"
#include "geometry/face_triangulation.h"

namespace mq::geometry {

/// What keeps a triangle from standing for its piece of the surface.
enum class TriangleFault {
    None,
    Turned,   ///< away from the normals of the surface, or these from each other
    Sagging,  ///< the surface bulges, or the triangle is upside down, because chords of the border are too long
};

// A triangle is coarse when normals at its corners, at its centroid and its own differ by more: 35 degrees leave room
// below the 60 degrees that the refinement relies on.
const double kCosMaxTurn = std::cos(35.0 * kDegree);
// At the apex of a cone every triangle turns, however small; it only must not fold.
const double kCosMaxTurnAtApex = std::cos(70.0 * kDegree);

/// A triangle on a face, with the point of the surface over its centroid.
struct TriangleOnFace {
    std::array<const FaceTriangulation::Site*, 3> corners;
    Vec3 on_surface;         ///< in the frame of the corners
    Vec3 surface_normal;     ///< there
    bool reversed;           ///< counter-clockwise in (u, v) is clockwise seen from outside
    double least_height;     ///< a flatter one need not follow the surface
    double sag_that_counts;  ///< mm
};

TriangleFault fault_of(const TriangleOnFace& triangle);

}  // namespace mq::geometry
