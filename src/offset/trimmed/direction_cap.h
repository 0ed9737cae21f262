// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::offset {

/// The direction at a fraction of the shortest arc between two directions; between opposite ones, on one of their arcs.
Vec3 on_arc(const Vec3& from, const Vec3& to, double fraction);

/// Triangles on the unit sphere.
struct DirectionCap {
    std::vector<Vec3> directions;  ///< the directions of the loop come first
    std::vector<mesh::Triangle> triangles;
};

/// Fills a closed loop on the unit sphere by a cap whose border runs along it. A loop bounds many caps, which differ by
/// whole spheres: the cap whose signed area is nearest to the angle defect of the vertex is taken (Gauss and Bonnet).
/// @param mean       a direction amid the loop; its length does not matter
/// @param curvature  the angle defect: 2 pi less the angles around the vertex
/// @param step       largest angle of the sides within the cap, radians
/// @param progress   may be null
/// @throws Cancelled
DirectionCap cap_over(const std::vector<Vec3>& loop, const Vec3& mean, double curvature, double step,
                      const Progress* progress = nullptr);

}  // namespace mq::offset
