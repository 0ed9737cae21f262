// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Returns the length of a half-edge, mm.
inline double side_length(const ClassifiedMesh& mesh, int h) {
    return (mesh.point_of(ClassifiedMesh::next(h)) - mesh.point_of(h)).norm();
}

inline double squared_length(const ClassifiedMesh& mesh, int h) {
    return (mesh.point_of(ClassifiedMesh::next(h)) - mesh.point_of(h)).squaredNorm();
}

/// Returns the shortest of a triangle's sides as a half-edge, the first one if several are equal.
inline int shortest_side(const ClassifiedMesh& mesh, int triangle) {
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
inline int longest_side(const ClassifiedMesh& mesh, int triangle) {
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
