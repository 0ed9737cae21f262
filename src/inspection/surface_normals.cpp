// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/surface_normals.h"

#include <algorithm>
#include <cmath>

#include "mesh/vertex_stars.h"

namespace mq::inspection {

namespace {

/// Cosine of the largest angle between neighbours without a CAD face that continue each other: 30 degrees.
const double kSmooth = std::cos(M_PI / 6.0);
/// Cosine of the largest angle between neighbours of one CAD face that continue each other: 75 degrees, as tiny
/// roundings have few triangles.
const double kSmoothOnFace = std::cos(75.0 * M_PI / 180.0);

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

SurfaceNormals::SurfaceNormals(const mesh::TriangleMesh& mesh, const Progress* progress)
    : plane_(mesh.triangles.size(), Vec3::Zero()), corner_(mesh.triangles.size()), allowance_(mesh.triangles.size()) {
    const auto vertex = [&](std::size_t k, int i) -> const Vec3& { return mesh.vertices[mesh.triangles[k][i]]; };
    // Weights of the triangles in the normals of vertices; the normals are exact on spheres with these weights (Max
    // 1999).
    std::vector<double> share(3 * plane_.size());
    CancelPace pace(progress);
    for (std::size_t k = 0; k < plane_.size(); ++k) {
        pace.step();
        const Vec3 normal = (vertex(k, 1) - vertex(k, 0)).cross(vertex(k, 2) - vertex(k, 0));
        const double area = normal.norm();
        plane_[k] = area > 0.0 ? Vec3(normal / area) : Vec3(Vec3::Zero());
        for (int i = 0; i < 3; ++i) {
            const double before = (vertex(k, i) - vertex(k, (i + 2) % 3)).squaredNorm();
            const double after = (vertex(k, (i + 1) % 3) - vertex(k, i)).squaredNorm();
            share[3 * k + i] = area > 0.0 ? area / (before * after) : 0.0;
        }
    }
    const bool has_faces = !mesh.triangle_face.empty();
    const auto continues = [&](std::size_t k, std::size_t other) {
        if (has_faces && (mesh.triangle_face[k] >= 0 || mesh.triangle_face[other] >= 0)) {
            return mesh.triangle_face[k] == mesh.triangle_face[other] && plane_[k].dot(plane_[other]) >= kSmoothOnFace;
        }
        return plane_[k].dot(plane_[other]) >= kSmooth;
    };
    const mesh::VertexStars stars(mesh.triangles, mesh.vertices.size());
    std::vector<double> at_vertex(mesh.vertices.size(), 0.0);
    for (std::size_t k = 0; k < plane_.size(); ++k) {
        pace.step();
        for (int i = 0; i < 3; ++i) {
            Vec3 sum = Vec3::Zero();
            for (const std::uint32_t corner : stars[static_cast<std::size_t>(mesh.triangles[k][i])]) {
                if (corner / 3 == k || continues(k, corner / 3)) {
                    sum += share[corner] * plane_[corner / 3];
                }
            }
            const double norm = sum.norm();
            corner_[k][i] = norm > 0.0 ? Vec3(sum / norm) : plane_[k];
        }
        double most = 0.0;
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            most = std::max(most,
                            0.5 * (vertex(k, j) - vertex(k, i)).norm() * angle_between(corner_[k][i], corner_[k][j]));
        }
        for (const std::int32_t v : mesh.triangles[k]) {
            at_vertex[v] = std::max(at_vertex[v], most);
        }
    }
    for (std::size_t k = 0; k < plane_.size(); ++k) {
        const mesh::Triangle& t = mesh.triangles[k];
        allowance_[k] = std::max({at_vertex[t[0]], at_vertex[t[1]], at_vertex[t[2]]});
    }
}

Vec3 SurfaceNormals::at(std::int32_t triangle, const Vec3& weights) const {
    const std::array<Vec3, 3>& corner = corner_[static_cast<std::size_t>(triangle)];
    const Vec3 sum = weights[0] * corner[0] + weights[1] * corner[1] + weights[2] * corner[2];
    const double norm = sum.norm();
    return norm > 0.0 ? Vec3(sum / norm) : of_plane(triangle);
}

}  // namespace mq::inspection
