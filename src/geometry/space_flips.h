// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/face_triangulation.h"
#include "geometry/planar_triangulation.h"

namespace mq::geometry {

/// Flips the edges of a triangulation in (u, v) as its sites lie in space: where the parameters are strongly warped,
/// Delaunay triangles in (u, v) are slivers that turn away from the surface. An edge is flipped when its two triangles
/// then turn less, or, with `for_angles`, when both are upright before and after and their smallest angle grows.
struct SpaceFlips {
    PlanarTriangulation& plane;
    const std::vector<FaceTriangulation::Site>& sites;
    const std::vector<int>& site_of;  ///< by vertex of the plane
    const std::vector<char>& inside;  ///< by triangle: 1 for those that count
    bool reversed;                    ///< counter-clockwise in (u, v) is clockwise seen from outside
    double upright;                   ///< cosine between the normals of a triangle and of its corners, enough
    bool for_angles;                  ///< upright triangles are flipped too, where their smallest angle grows

    void run();

  private:
    bool better_flipped(int h) const;
    double uprightness(int a, int b, int c) const;
    const FaceTriangulation::Site& site(int vertex) const { return sites[site_of[vertex]]; }
};

}  // namespace mq::geometry
