// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "triangulate/initial/face_boundary.h"

namespace mq::triangulate {

/// A line segment in a plane.
using Segment2 = std::array<Vec2, 2>;
using Triangle2 = std::array<Vec2, 3>;

/// Returns the border of a face in (u, v), closed even where it runs along one vertex; without edges inside the face.
std::vector<Segment2> outline_of(const FaceBoundary& border);

/// Whether the segment has a point in the closed triangle, whose corners may have either orientation. Exact.
bool meets(const Triangle2& triangle, const Segment2& segment);

/// Whether the line from p to q crosses the segment: an odd number of crossings leads from inside an outline to its
/// outside. An end of the segment on the line counts as left of it. Exact.
bool crosses(const Vec2& p, const Vec2& q, const Segment2& segment);

}  // namespace mq::triangulate
