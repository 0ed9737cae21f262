// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.h"

/// Closed solids, coordinates in single precision.
namespace mq::boolean::solids {

inline void round_vertices(mesh::TriangleMesh& mesh) {
    for (Vec3& p : mesh.vertices) {
        p = to_single(p);
    }
}

inline mesh::TriangleMesh box(const Vec3& low, const Vec3& high) {
    mesh::TriangleMesh mesh;
    for (int k = 0; k < 8; ++k) {
        mesh.vertices.emplace_back((k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(),
                                   (k & 4) != 0 ? high.z() : low.z());
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    round_vertices(mesh);
    return mesh;
}

/// A sphere of 2 n by n facets; `wobble` moves each vertex by up to that fraction of the radius along it.
inline mesh::TriangleMesh sphere(const Vec3& center, double radius, int n, double wobble = 0.0, unsigned seed = 1) {
    mesh::TriangleMesh mesh;
    std::mt19937 random(seed);
    const auto point = [&](double polar, double around) {
        const double r = radius * (1.0 + wobble * (random() / 4294967295.0 - 0.5));
        mesh.vertices.push_back(
            center + r * Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)));
    };
    const auto at = [n](int row, int i) { return static_cast<std::int32_t>(2 + (row - 1) * 2 * n + i % (2 * n)); };
    point(0.0, 0.0);
    point(M_PI, 0.0);
    for (int row = 1; row < n; ++row) {
        for (int i = 0; i < 2 * n; ++i) {
            point(M_PI * row / n, M_PI * i / n);
        }
    }
    for (int i = 0; i < 2 * n; ++i) {
        mesh.triangles.push_back({0, at(1, i), at(1, i + 1)});
        mesh.triangles.push_back({1, at(n - 1, i + 1), at(n - 1, i)});
        for (int row = 1; row + 1 < n; ++row) {
            mesh.triangles.push_back({at(row, i), at(row + 1, i), at(row + 1, i + 1)});
            mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row, i + 1)});
        }
    }
    round_vertices(mesh);
    return mesh;
}

/// Both as one mesh.
inline mesh::TriangleMesh together(mesh::TriangleMesh a, const mesh::TriangleMesh& b) {
    const auto shift = static_cast<std::int32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const mesh::Triangle& t : b.triangles) {
        a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    }
    return a;
}

/// The triangles whose centroids a condition holds for.
template <typename Condition>
mesh::TriangleMesh only(mesh::TriangleMesh mesh, const Condition& condition) {
    std::vector<mesh::Triangle> left;
    for (const mesh::Triangle& t : mesh.triangles) {
        if (condition(Vec3((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0))) {
            left.push_back(t);
        }
    }
    mesh.triangles = std::move(left);
    return mesh;
}

}  // namespace mq::boolean::solids
