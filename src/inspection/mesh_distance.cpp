// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/mesh_distance.h"

#include <cmath>

#include "base/segment_distance.h"
#include "mesh/weld_vertices.h"

namespace mq::inspection {

namespace {

/// Points this near to an edge or a vertex, as a fraction of the triangle's size, are on it: the rounding of the
/// nearest point. Its pseudonormal has the right sign for points of the triangles around it, too.
constexpr double kOn = 1e-9;

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

SignedDistance signed_distance(const Vec3& point, const Vec3& nearest, const Vec3& normal) {
    // Below this fraction of the coordinates a direction between two points is rounding.
    constexpr double kDirection = 1e-9;
    SignedDistance found;
    const Vec3 way = point - nearest;
    const double distance = way.norm(), side = way.dot(normal) < 0.0 ? -1.0 : 1.0;
    found.value = side * distance;
    found.nearest = nearest;
    const bool has_direction = distance > kDirection * (1.0 + point.cwiseAbs().maxCoeff());
    found.normal = has_direction ? Vec3(side / distance * way) : Vec3(normal.normalized());
    return found;
}

MeshDistance::MeshDistance(const mesh::TriangleMesh& mesh)
    : mesh_(mesh), triangles_(welded()), tree_(mesh.vertices, triangles_), stars_(triangles_, mesh.vertices.size()) {}

std::vector<mesh::Triangle> MeshDistance::welded() const {
    const std::vector<std::int32_t> lowest = mesh::equal_vertices(mesh_.vertices);
    std::vector<mesh::Triangle> triangles = mesh_.triangles;
    for (mesh::Triangle& t : triangles) {
        for (std::int32_t& v : t) {
            v = lowest[static_cast<std::size_t>(v)];
        }
    }
    return triangles;
}

Vec3 MeshDistance::unit_normal(std::int32_t triangle) const {
    const mesh::Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
    const Vec3 &a = mesh_.vertices[t[0]], &b = mesh_.vertices[t[1]], &c = mesh_.vertices[t[2]];
    return (b - a).cross(c - a).normalized();
}

Vec3 MeshDistance::pseudonormal(std::int32_t triangle, const Vec3& at) const {
    const mesh::Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
    const auto point = [&](int i) -> const Vec3& { return mesh_.vertices[t[(i + 3) % 3]]; };
    const double on = kOn * ((point(1) - point(0)).norm() + (point(2) - point(0)).norm());
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        if ((at - point(i)).norm() > on) {
            continue;
        }
        for (const std::uint32_t corner : stars_[static_cast<std::size_t>(t[i])]) {
            const auto other = static_cast<std::int32_t>(corner / 3);
            const mesh::Triangle& o = triangles_[static_cast<std::size_t>(other)];
            const int k = static_cast<int>(corner % 3);
            const Vec3& apex = mesh_.vertices[o[k]];
            sum += angle_between(mesh_.vertices[o[(k + 1) % 3]] - apex, mesh_.vertices[o[(k + 2) % 3]] - apex) *
                   unit_normal(other);
        }
        return sum;
    }
    for (int i = 0; i < 3; ++i) {
        if (distance_to_segment(at, point(i), point(i + 1)) > on) {
            continue;
        }
        const std::int32_t far = t[(i + 1) % 3];
        for (const std::uint32_t corner : stars_[static_cast<std::size_t>(t[i])]) {
            const auto other = static_cast<std::int32_t>(corner / 3);
            const mesh::Triangle& o = triangles_[static_cast<std::size_t>(other)];
            if (o[0] == far || o[1] == far || o[2] == far) {
                sum += unit_normal(other);
            }
        }
        return sum;
    }
    return unit_normal(triangle);
}

SignedDistance MeshDistance::at(const Vec3& point, std::int32_t guess) const {
    const mesh::ClosestPoint near = nearest(point, guess);
    SignedDistance found = signed_distance(point, near.point, pseudonormal(near.triangle, near.point));
    found.triangle = near.triangle;
    if (!mesh_.triangle_face.empty()) {
        found.face = mesh_.triangle_face[static_cast<std::size_t>(near.triangle)];
    }
    return found;
}

}  // namespace mq::inspection
