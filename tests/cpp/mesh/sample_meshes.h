// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

#include "mesh/triangle_mesh.h"

/// Small meshes with known properties.
namespace mq::mesh::samples {

inline TriangleMesh tetrahedron() {
    TriangleMesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    mesh.triangle_face = {0, 1, 2, 3};
    mesh.vertex_entity = {{0, 0}, {0, 1}, {0, 2}, {0, 3}};
    return mesh;
}

/// A torus of n by n quadrilaterals, two triangles each, coordinates rounded to single precision.
inline TriangleMesh torus(int n, double major = 3.0, double minor = 1.0) {
    TriangleMesh mesh;
    const double step = 2.0 * M_PI / n;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double r = major + minor * std::cos(j * step);
            const Vec3 p(r * std::cos(i * step), r * std::sin(i * step), minor * std::sin(j * step));
            mesh.vertices.push_back(to_single(p));
            const auto at = [&](int a, int b) { return static_cast<std::int32_t>((a % n) * n + b % n); };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    mesh.triangle_face.assign(mesh.triangles.size(), 0);
    mesh.vertex_entity.assign(mesh.vertices.size(), {2, 0});
    return mesh;
}

}  // namespace mq::mesh::samples
