// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/surface_mesh.h"

namespace mq::triangulate {

/// Of a half-edge, mm.
inline double side_length(const mesh::SurfaceMesh& mesh, int h) {
    return (mesh.point_of(mesh::SurfaceMesh::next(h)) - mesh.point_of(h)).norm();
}

inline double squared_length(const mesh::SurfaceMesh& mesh, int h) {
    return (mesh.point_of(mesh::SurfaceMesh::next(h)) - mesh.point_of(h)).squaredNorm();
}

/// Of a triangle's sides, as half-edges; of equal ones the first.
inline int shortest_side(const mesh::SurfaceMesh& mesh, int triangle) {
    int best = 3 * triangle;
    double least = squared_length(mesh, best);
    for (int h = best + 1; h < 3 * triangle + 3; ++h) {
        const double length = squared_length(mesh, h);
        if (length < least) {
            least = length;
            best = h;
        }
    }
    return best;
}
inline int longest_side(const mesh::SurfaceMesh& mesh, int triangle) {
    int best = 3 * triangle;
    double most = squared_length(mesh, best);
    for (int h = best + 1; h < 3 * triangle + 3; ++h) {
        const double length = squared_length(mesh, h);
        if (length > most) {
            most = length;
            best = h;
        }
    }
    return best;
}

}  // namespace mq::triangulate
