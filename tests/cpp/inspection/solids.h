// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "mesh/triangle_mesh.h"

/// Closed meshes of solids with known dimensions, without CAD.
namespace mq::inspection::solids {

/// Adds the triangles of another mesh, turned inside out if it is a cavity.
inline void add(mesh::TriangleMesh& mesh, const mesh::TriangleMesh& other, bool is_cavity = false) {
    const auto start = static_cast<std::int32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (mesh::Triangle t : other.triangles) {
        if (is_cavity) {
            std::swap(t[1], t[2]);
        }
        mesh.triangles.push_back({start + t[0], start + t[1], start + t[2]});
    }
}

/// A hexahedron of 12 triangles. Corner k has the bits x, y, z of k from the lowest.
inline mesh::TriangleMesh hexahedron(const std::array<Vec3, 8>& corners) {
    mesh::TriangleMesh mesh;
    mesh.vertices.assign(corners.begin(), corners.end());
    for (const std::array<std::int32_t, 4>& q : {std::array<std::int32_t, 4>{0, 2, 3, 1},
                                                 {4, 5, 7, 6},
                                                 {0, 1, 5, 4},
                                                 {2, 6, 7, 3},
                                                 {0, 4, 6, 2},
                                                 {1, 3, 7, 5}}) {
        mesh.triangles.push_back({q[0], q[1], q[2]});
        mesh.triangles.push_back({q[0], q[2], q[3]});
    }
    return mesh;
}

inline mesh::TriangleMesh box(const Vec3& low, const Vec3& high) {
    std::array<Vec3, 8> corners;
    for (int k = 0; k < 8; ++k) {
        for (int i = 0; i < 3; ++i) {
            corners[static_cast<std::size_t>(k)][i] = (k >> i & 1) != 0 ? high[i] : low[i];
        }
    }
    return hexahedron(corners);
}

/// A pipe along z with this number of sides, and rows of triangles of about equal sides; inner 0: a solid bar.
inline mesh::TriangleMesh pipe(double inner, double outer, double height, int sides) {
    mesh::TriangleMesh mesh;
    const int rows = static_cast<int>(std::ceil(height / (2.0 * M_PI * outer / sides)));
    const auto wall = [&](double radius, bool outward) {
        const auto start = static_cast<std::int32_t>(mesh.vertices.size());
        for (int row = 0; row <= rows; ++row) {
            for (int i = 0; i < sides; ++i) {
                const double angle = 2.0 * M_PI * i / sides;
                mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height * row / rows);
            }
        }
        for (int row = 0; row < rows; ++row) {
            for (int i = 0; i < sides; ++i) {
                const std::int32_t a = start + row * sides + i;
                const std::int32_t b = start + row * sides + (i + 1) % sides;
                mesh::Triangle first{a, b, b + sides};
                mesh::Triangle second{a, b + sides, a + sides};
                if (!outward) {
                    std::swap(first[1], first[2]);
                    std::swap(second[1], second[2]);
                }
                mesh.triangles.push_back(first);
                mesh.triangles.push_back(second);
            }
        }
        return start;
    };
    const std::int32_t out = wall(outer, true);
    const std::int32_t top = rows * sides;
    if (inner > 0.0) {
        const std::int32_t in = wall(inner, false);
        for (int i = 0; i < sides; ++i) {
            const int j = (i + 1) % sides;
            mesh.triangles.push_back({out + i, in + i, in + j});
            mesh.triangles.push_back({out + i, in + j, out + j});
            mesh.triangles.push_back({out + top + i, in + top + j, in + top + i});
            mesh.triangles.push_back({out + top + i, out + top + j, in + top + j});
        }
        return mesh;
    }
    for (const std::int32_t end : {0, top}) {
        const auto center = static_cast<std::int32_t>(mesh.vertices.size());
        mesh.vertices.emplace_back(0.0, 0.0, end == 0 ? 0.0 : height);
        for (int i = 0; i < sides; ++i) {
            const int j = (i + 1) % sides;
            mesh.triangles.push_back(end == 0 ? mesh::Triangle{center, j, i}
                                              : mesh::Triangle{center, top + i, top + j});
        }
    }
    return mesh;
}

/// An octahedron divided `rounds` times, its vertices on the sphere.
inline mesh::TriangleMesh sphere(double radius, int rounds, const Vec3& center = Vec3::Zero()) {
    mesh::TriangleMesh mesh;
    mesh.vertices = {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int round = 0; round < rounds; ++round) {
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
        const auto middle = [&](std::int32_t a, std::int32_t b) {
            const auto [at, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(mesh.vertices.size()));
            if (is_new) {
                mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
            }
            return at->second;
        };
        std::vector<mesh::Triangle> finer;
        for (const mesh::Triangle& t : mesh.triangles) {
            const std::int32_t m[3] = {middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
            finer.insert(finer.end(), {{t[0], m[0], m[2]}, {t[1], m[1], m[0]}, {t[2], m[2], m[1]}, {m[0], m[1], m[2]}});
        }
        mesh.triangles.swap(finer);
    }
    for (Vec3& p : mesh.vertices) {
        p = center + radius * p;
    }
    return mesh;
}

}  // namespace mq::inspection::solids
