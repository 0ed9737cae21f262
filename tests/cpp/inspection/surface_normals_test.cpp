// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/surface_normals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "inspection/solids.h"

namespace mq::inspection {
namespace {

const Vec3 kMiddle(1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0);

TEST(SurfaceNormals, OfAPlaneAreThoseOfTheTriangle) {
    const mesh::TriangleMesh mesh = solids::box(Vec3(0, 0, 0), Vec3(4, 3, 2));
    const SurfaceNormals normals(mesh);
    for (std::int32_t k = 0; k < 12; ++k) {
        EXPECT_LT((normals.at(k, kMiddle) - normals.of_plane(k)).norm(), 1e-15);
        EXPECT_EQ(normals.allowance(k), 0.0);
    }
}

TEST(SurfaceNormals, OfASphereAreExact) {
    const mesh::TriangleMesh mesh = solids::sphere(5.0, 3, Vec3(1, 2, 3));
    const SurfaceNormals normals(mesh);
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const mesh::Triangle& t = mesh.triangles[k];
        const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
        const Vec3 outward = (middle - Vec3(1, 2, 3)).normalized();
        EXPECT_LT((normals.at(static_cast<std::int32_t>(k), kMiddle) - outward).norm(), 1e-12);
    }
}

TEST(SurfaceNormals, AllowFourTimesTheChordHeight) {
    constexpr int kSides = 60;
    mesh::TriangleMesh mesh = solids::pipe(0.0, 5.0, 20.0, kSides);
    mesh.triangle_face.assign(mesh.triangles.size(), 0);
    for (std::size_t k = mesh.triangles.size() - 2 * kSides; k < mesh.triangles.size(); ++k) {
        mesh.triangle_face[k] = 1;  // the ends
    }
    const SurfaceNormals normals(mesh);
    const double chord_height = 5.0 * (1.0 - std::cos(M_PI / kSides));
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const double found = normals.allowance(static_cast<std::int32_t>(k));
        if (mesh.triangle_face[k] == 0) {
            // The diagonals of the squares are longer than the chords by the square root of 2.
            EXPECT_GT(found, 3.9 * chord_height);
            EXPECT_LT(found, 6.0 * chord_height);
        }
    }
}

TEST(SurfaceNormals, EndAtCadFaces) {
    // Two planes that meet at 20 degrees: one surface without CAD, two with it.
    mesh::TriangleMesh mesh;
    const double angle = M_PI / 9.0;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(std::cos(angle), 0, std::sin(angle))};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
    const SurfaceNormals smooth(mesh);
    EXPECT_GT((smooth.at(0, kMiddle) - smooth.of_plane(0)).norm(), 0.05);
    mesh.triangle_face = {0, 1};
    const SurfaceNormals sharp(mesh);
    EXPECT_LT((sharp.at(0, kMiddle) - sharp.of_plane(0)).norm(), 1e-15);
}

}  // namespace
}  // namespace mq::inspection
