// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <vector>

#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// The closest point to a query point on a set of faces.
struct SurfaceProjection {
    double distance = std::numeric_limits<double>::infinity();  ///< mm; infinite: none was found
    int face = -1;              ///< face of the closest point; -1: it is on an edge between faces
    Vec3 point = Vec3::Zero();  ///< in the shape's frame
    Vec2 uv = Vec2::Zero();
    Vec3 normal = Vec3::Zero();

    bool found() const { return distance < std::numeric_limits<double>::infinity(); }
};

/// Projects points of the mesh onto `sheets`. If there are several faces, only projections inside their trimmed
/// regions count, since a face may extend beyond its border where the shape has another surface. Where no face has
/// one, points are projected onto the edges between the faces. The distance is therefore never less than that from the
/// shape.
std::vector<SurfaceProjection> project_onto(Workspace& work, const std::vector<Vec3>& points,
                                            const CandidateFaces& sheets);

/// Adds sample points of an edge, or of the inside of a triangle, that may lie on several faces: the distance may peak
/// anywhere if a face ends within.
void sample_edge(const Vec3& a, const Vec3& b, std::vector<Vec3>& points);
void sample_triangle(const Vec3& a, const Vec3& b, const Vec3& c, std::vector<Vec3>& points);

}  // namespace mq::triangulate
