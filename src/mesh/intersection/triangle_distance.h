// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "base/vec.h"

namespace mq::mesh {

/// The point of the triangle (a, b, c) nearest to p (Ericson, Real-Time Collision Detection, section 5.1.5).
Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// The nearest points of two triangles.
struct TriangleDistance {
    double distance = 0.0;  ///< mm; 0 where they meet
    Vec3 on_first = Vec3::Zero();
    Vec3 on_second = Vec3::Zero();
    /// mm: how deep an edge of one triangle passes through the other: the smaller distance of the edge's ends from the
    /// other's plane; the largest over all edges. It tells triangles that cross from those that meet by rounding or by
    /// their facets.
    double depth = 0.0;
};

/// A triangle by its corners.
using Corners = std::array<Vec3, 3>;

/// Nearest points of the segments from p to q and from r to s (Ericson, Real-Time Collision Detection, section 5.1.9).
std::array<Vec3, 2> nearest_of_segments(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s);

/// Distance of two triangles, neither of them without area. Whether they meet is decided exactly.
TriangleDistance triangle_distance(const Corners& first, const Corners& second);

}  // namespace mq::mesh
