// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <vector>

#include "triangulate/workspace.h"

namespace mq::triangulate {

/// The nearest point of some faces.
struct Foot {
    double distance = std::numeric_limits<double>::infinity();  ///< mm; infinite: none was found
    int face = -1;                                              ///< that it lies on; -1: on an edge between them
    Vec3 point = Vec3::Zero();                                  ///< in the part's frame
    Vec2 uv = Vec2::Zero();
    Vec3 normal = Vec3::Zero();

    bool found() const { return distance < std::numeric_limits<double>::infinity(); }
};

/// The feet of points of the mesh on `sheets`. Where there are several faces only feet inside their trimmed regions
/// count: a face may go on beyond its border where the part has another surface. Where no face has one, the edges
/// between the faces are asked. So a distance is never less than that from the part.
std::vector<Foot> feet_on(Workspace& work, const std::vector<Vec3>& points, const Sheets& sheets);

/// Adds the points where an edge, or the inside of a triangle, is measured that may lie on several faces: the distance
/// may peak anywhere where a face ends within.
void sample_edge(const Vec3& a, const Vec3& b, std::vector<Vec3>& points);
void sample_triangle(const Vec3& a, const Vec3& b, const Vec3& c, std::vector<Vec3>& points);

}  // namespace mq::triangulate
