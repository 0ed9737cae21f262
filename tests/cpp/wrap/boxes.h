// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::test {

/// Adds the box between two corners; each of its six faces may be left out.
inline void add_box(mesh::TriangleMesh& mesh, const Vec3& low, const Vec3& high, int left_out = -1) {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    for (int k = 0; k < 8; ++k) {
        mesh.vertices.emplace_back((k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(),
                                   (k & 4) != 0 ? high.z() : low.z());
    }
    const std::vector<std::array<std::int32_t, 4>> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int k = 0; k < 6; ++k) {
        if (k != left_out) {
            const std::array<std::int32_t, 4>& f = faces[static_cast<std::size_t>(k)];
            mesh.triangles.push_back({first + f[0], first + f[1], first + f[2]});
            mesh.triangles.push_back({first + f[0], first + f[2], first + f[3]});
        }
    }
}

inline double volume(const mesh::TriangleMesh& mesh) {
    double sum = 0.0;
    for (const mesh::Triangle& t : mesh.triangles) {
        sum += mesh.vertices[static_cast<std::size_t>(t[0])]
                   .cross(mesh.vertices[static_cast<std::size_t>(t[1])])
                   .dot(mesh.vertices[static_cast<std::size_t>(t[2])]) /
               6.0;
    }
    return sum;
}

}  // namespace mq::test
