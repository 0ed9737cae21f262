// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/cad_normals.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>

#include "geometry/occt/shape_model.h"
#include "geometry/session.h"

namespace mq::workflows {

namespace {

/// A point beside a CAD face.
struct PointBesideFace {
    std::int32_t face;
    Vec3 point;  ///< in the frame of the shape
};

/// Unit normals of the faces at their points nearest to the given ones; zero where a surface has none.
std::vector<Vec3> nearest_normals(geometry::Engine& engine, const std::vector<PointBesideFace>& points,
                                  const TopoDS_Shape& shape, Progress& progress) {
    std::shared_ptr<geometry::Model> model;
    engine.run([&] { model = geometry::make_shape_model(shape, &progress); }, &progress);
    geometry::Session session(engine, model, &progress);
    geometry::Engine::Batch batch;
    for (const PointBesideFace& at : points) {
        batch.push_back(geometry::Query::face_nearest_global(at.face, at.point));
    }
    std::vector<Vec3> normals;
    for (const geometry::Answer& answer : session.ask(std::move(batch))) {
        const bool known = answer.status == geometry::Status::Ok && answer.normal.squaredNorm() > 0.5;
        normals.push_back(known ? answer.normal : Vec3(Vec3::Zero()));
    }
    return normals;
}

Vec3 normal_of(const mesh::TriangleMesh& mesh, std::size_t triangle) {
    const mesh::Triangle& t = mesh.triangles[triangle];
    const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
    return (mesh.vertices[static_cast<std::size_t>(t[1])] - a)
        .cross(mesh.vertices[static_cast<std::size_t>(t[2])] - a)
        .normalized();
}

/// Outward of the solid, whichever way the face is turned.
Vec3 turned_to(const Vec3& outward, const Vec3& normal) {
    return outward.dot(normal) < 0.0 ? Vec3(-normal) : normal;
}

}  // namespace

std::vector<Vec3> cad_normals(geometry::Engine& engine, const mesh::TriangleMesh& mesh, const TopoDS_Shape& shape,
                              Progress& progress, std::size_t& exact) {
    std::vector<Vec3> normals;
    std::vector<PointBesideFace> points;
    std::vector<std::size_t> asked;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        normals.push_back(normal_of(mesh, k));
        if (!mesh.triangle_face.empty() && mesh.triangle_face[k] >= 0) {
            Vec3 sum = Vec3::Zero();
            for (const std::int32_t v : mesh.triangles[k]) {
                sum += mesh.vertices[static_cast<std::size_t>(v)];
            }
            points.push_back({mesh.triangle_face[k], sum / 3.0 + mesh.origin});
            asked.push_back(k);
        }
    }
    const std::vector<Vec3> found = nearest_normals(engine, points, shape, progress);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (!found[i].isZero(0.0)) {
            normals[asked[i]] = turned_to(normals[asked[i]], found[i]);
            ++exact;
        }
    }
    return normals;
}

std::vector<Vec3> corner_normals(geometry::Engine& engine, const mesh::TriangleMesh& mesh, const TopoDS_Shape& shape,
                                 Progress& progress) {
    if (mesh.triangle_face.empty()) {
        return {};
    }
    using Key = std::array<std::int32_t, 2>;  // face, vertex
    std::vector<Key> keys;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::int32_t v : mesh.triangles[t]) {
            if (mesh.triangle_face[t] >= 0) {
                keys.push_back({mesh.triangle_face[t], v});
            }
        }
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<PointBesideFace> points;
    points.reserve(keys.size());
    for (const auto& [face, v] : keys) {
        points.push_back({face, mesh.vertices[static_cast<std::size_t>(v)] + mesh.origin});
    }
    const std::vector<Vec3> found = nearest_normals(engine, points, shape, progress);
    std::vector<Vec3> normals(3 * mesh.triangles.size(), Vec3::Zero());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 outward = normal_of(mesh, t);
        for (std::size_t k = 0; k < 3 && mesh.triangle_face[t] >= 0; ++k) {
            const auto at =
                std::lower_bound(keys.begin(), keys.end(), Key{mesh.triangle_face[t], mesh.triangles[t][k]});
            normals[3 * t + k] = turned_to(outward, found[static_cast<std::size_t>(at - keys.begin())]);
        }
    }
    return normals;
}

}  // namespace mq::workflows
