// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/triangle_mesh.h"

namespace mq::improve {

/// A flat square of `cells` by `cells` unit squares, two triangles each; vertices run row by row.
inline mesh::TriangleMesh flat_grid(int cells) {
    mesh::TriangleMesh mesh;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            mesh.vertices.emplace_back(i, j, 0);
        }
    }
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const int a = j * (cells + 1) + i, c = a + cells + 2;
            mesh.triangles.push_back({a, a + 1, c});
            mesh.triangles.push_back({a, c, c - 1});
        }
    }
    return mesh;
}

}  // namespace mq::improve
