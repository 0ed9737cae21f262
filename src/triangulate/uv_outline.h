// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "geometry/face_border.h"

namespace mq::triangulate {

/// A line segment in a plane.
using Segment2 = std::array<Vec2, 2>;
using Triangle2 = std::array<Vec2, 3>;

/// The border of a face in (u, v), closed also where it runs along one vertex; without edges inside the face.
std::vector<Segment2> outline_of(const geometry::FaceBorder& border);

/// The segment has a point in the closed triangle, whose corners may run either way. Exact.
bool meets(const Triangle2& triangle, const Segment2& segment);

/// The way from p to q crosses the segment: an odd number of crossings leads from inside an outline to its outside. An
/// end of the segment on the line of the way counts as left of it. Exact.
bool crosses(const Vec2& p, const Vec2& q, const Segment2& segment);

}  // namespace mq::triangulate
