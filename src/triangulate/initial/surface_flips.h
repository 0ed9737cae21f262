// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/initial/constrained_delaunay.h"
#include "triangulate/initial/face_triangulator.h"

namespace mq::triangulate {

/// Flips the edges of a triangulation in (u, v) by the positions of its sites in space: where the parameters are
/// strongly warped, Delaunay triangles in (u, v) are slivers whose normals deviate from the surface. An edge is
/// flipped if this reduces the deviation of its two triangles; or, with `for_angles`, if both are upright before and
/// after and their smallest angle grows.
struct SurfaceFlips {
    ConstrainedDelaunay& plane;
    const std::vector<FaceMesh::VertexUse>& sites;
    const std::vector<int>& site_of;  ///< by vertex of the plane
    const std::vector<char>& inside;  ///< by triangle: 1 inside the face
    bool reversed;                    ///< counter-clockwise in (u, v) is clockwise seen from outside
    double upright;                   ///< sufficient cosine between the normals of a triangle and of its corners
    bool for_angles;                  ///< also flips upright triangles if their smallest angle grows

    void run();

  private:
    bool better_flipped(int h) const;
    double uprightness(int a, int b, int c) const;
    const FaceMesh::VertexUse& site(int vertex) const { return sites[site_of[vertex]]; }
};

}  // namespace mq::triangulate
