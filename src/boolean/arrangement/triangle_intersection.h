// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <unordered_map>
#include <utility>
#include <vector>

#include "base/key_set.h"
#include "boolean/arrangement/point_table.h"
#include "boolean/arrangement/soup.h"

namespace mq::boolean {

/// A piece of the line in which a triangle meets another one.
struct Segment {
    std::int32_t from = -1;   ///< point
    std::int32_t to = -1;     ///< point
    std::int32_t other = -1;  ///< triangle of the soup
};

/// The points and segments that intersections put on the triangles. A point on an edge is recorded with the edge, so
/// that both of its triangles are divided alike.
struct Incidences {
    std::unordered_map<EdgeKey, std::vector<std::int32_t>, KeyHash> on_edge;
    std::unordered_map<std::int32_t, std::vector<std::int32_t>> in_face;
    std::unordered_map<std::int32_t, std::vector<Segment>> segments;
    /// Pairs of triangles in one plane whose insides meet.
    std::vector<std::pair<std::int32_t, std::int32_t>> overlapping;
};

/// Intersects two triangles that are not degenerate, exactly, and adds what they have in common beyond shared vertices
/// and edges.
void intersect(const Soup& soup, std::int32_t s, std::int32_t t, PointTable& points, Incidences& found);

/// The axis along which the triangle has its largest area.
int projection_axis(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace mq::boolean
