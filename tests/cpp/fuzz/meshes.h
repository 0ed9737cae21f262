// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>

#include "bytes.h"
#include "mesh/triangle_mesh.h"

/// Small meshes from the bytes of a fuzz target.
namespace mq::fuzz {

/// What the numbers of a mesh may be.
enum class Numbers {
    Any,   ///< infinite, not a number, out of range
    Safe,  ///< of sizes that predicates are exact for; every index names a vertex
};

/// Vertices and triangles as the bytes say them.
inline mesh::TriangleMesh raw_mesh(Bytes& bytes, Numbers numbers) {
    constexpr int kVertices = 24;
    constexpr int kTriangles = 40;
    mesh::TriangleMesh mesh;
    const int vertices = bytes.number(1, kVertices);
    const int triangles = bytes.number(0, kTriangles);
    for (int i = 0; i < vertices; ++i) {
        mesh.vertices.push_back(numbers == Numbers::Any ? bytes.point() : to_single(bytes.safe_point()));
    }
    constexpr int kStray = 250;  // of 256: an index that may be any number
    for (int k = 0; k < triangles; ++k) {
        mesh::Triangle& t = mesh.triangles.emplace_back();
        for (std::int32_t& v : t) {
            const int said = bytes.take<std::uint8_t>();
            v = numbers == Numbers::Any && said >= kStray ? bytes.take<std::int32_t>() : said % vertices;
        }
    }
    return mesh;
}

/// A closed solid of flat sides: a prism over a polygon, or a pyramid.
inline mesh::TriangleMesh closed_mesh(Bytes& bytes) {
    constexpr int kMostSides = 8;
    const int sides = bytes.number(3, kMostSides);
    const bool pyramid = bytes.number(0, 1) > 0;
    const double height = bytes.number(1, 16) * 0.25;
    mesh::TriangleMesh mesh;
    const auto ring = [&](double z) {
        for (int i = 0; i < sides; ++i) {
            const double angle = 2.0 * M_PI * i / sides;
            mesh.vertices.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), z);
        }
    };
    ring(0.0);
    const int apex = sides;
    if (pyramid) {
        mesh.vertices.emplace_back(0.25 * bytes.take<std::int8_t>() / 16.0, 0.0, height);
    } else {
        ring(height);
    }
    for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        if (i > 0 && j > 0) {
            mesh.triangles.push_back({0, j, i});
        }
        if (pyramid) {
            mesh.triangles.push_back({i, j, apex});
            continue;
        }
        mesh.triangles.push_back({i, j, sides + j});
        mesh.triangles.push_back({i, sides + j, sides + i});
        if (i > 0 && j > 0) {
            mesh.triangles.push_back({sides, sides + i, sides + j});
        }
    }
    return mesh;
}

/// Turned, stretched and moved; most often by round numbers, so that faces of two meshes meet.
inline void place(mesh::TriangleMesh& mesh, Bytes& bytes) {
    const int turn = bytes.number(0, 7);
    const double angle = turn < 6 ? turn * M_PI / 4.0 : bytes.part(0.0, M_PI);
    Vec3 axis = Vec3::UnitZ();
    if (turn == 7) {
        const double x = bytes.part(-1.0, 1.0);
        axis = Vec3(x, 1.0, bytes.part(-1.0, 1.0)).normalized();
    }
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    const Vec3 stretch{bytes.number(1, 8) * 0.25, bytes.number(1, 8) * 0.25, bytes.number(1, 8) * 0.25};
    const Vec3 shift{bytes.number(-8, 8) * 0.25, bytes.number(-8, 8) * 0.25, bytes.number(-8, 8) * 0.25};
    for (Vec3& p : mesh.vertices) {
        p = to_single(rotation * p.cwiseProduct(stretch) + shift);
    }
}

/// Triangles left out, doubled, turned or bent, vertices moved.
inline void damage(mesh::TriangleMesh& mesh, Bytes& bytes) {
    for (int i = bytes.number(0, 3); i > 0; --i) {
        const std::size_t t = bytes.take<std::uint8_t>() % mesh.triangles.size();
        switch (bytes.number(0, 4)) {
            case 0:
                if (mesh.triangles.size() > 1) {
                    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
                }
                break;
            case 1: {
                const mesh::Triangle again = mesh.triangles[t];
                mesh.triangles.push_back(again);
                break;
            }
            case 2:
                std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
                break;
            case 3:
                mesh.triangles[t][0] = static_cast<int>(bytes.take<std::uint8_t>() % mesh.vertices.size());
                break;
            default:
                mesh.vertices[bytes.take<std::uint8_t>() % mesh.vertices.size()] = to_single(bytes.safe_point());
        }
    }
}

}  // namespace mq::fuzz
