// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/mesh_distance.h"

#include <gtest/gtest.h>

#include <random>

#include "inspection/solids.h"

namespace mq::inspection {
namespace {

double distance_from_box(const Vec3& p, const Vec3& low, const Vec3& high) {
    const Vec3 outside = (low - p).cwiseMax(p - high);
    return outside.cwiseMax(0.0).norm() + std::min(outside.maxCoeff(), 0.0);
}

TEST(MeshDistance, IsThatOfABoxWithSigns) {
    const Vec3 low(0, 0, 0), high(3, 2, 1);
    const mesh::TriangleMesh box = solids::box(low, high);
    const MeshDistance mesh(box);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-1.0, 4.0);
    std::int32_t guess = -1;
    for (int k = 0; k < 5000; ++k) {
        const Vec3 p(place(random), place(random), place(random));
        const SignedDistance found = mesh.at(p, guess);
        guess = found.triangle;
        EXPECT_NEAR(found.value, distance_from_box(p, low, high), 1e-14) << p.transpose();
        EXPECT_NEAR((p - found.nearest).norm(), std::abs(found.value), 1e-14);
        EXPECT_NEAR((p - found.nearest - found.value * found.normal).norm(), 0.0, 1e-13);
    }
}

TEST(MeshDistance, HasTheRightSignInACavityAndAtItsCorners) {
    mesh::TriangleMesh shell = solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    solids::add(shell, solids::box(Vec3(3, 3, 3), Vec3(7, 7, 7)), true);
    const MeshDistance mesh(shell);
    EXPECT_NEAR(mesh.at(Vec3(5, 5, 6), -1).value, 1.0, 1e-14);              // in the cavity
    EXPECT_NEAR(mesh.at(Vec3(5, 5, 8), -1).value, -1.0, 1e-14);             // in the wall
    EXPECT_NEAR(mesh.at(Vec3(2, 2, 2), -1).value, -std::sqrt(3.0), 1e-14);  // towards a corner of the cavity
    EXPECT_NEAR(mesh.at(Vec3(11, 11, 11), -1).value, std::sqrt(3.0), 1e-14);
}

TEST(MeshDistance, CountsVerticesInOnePlaceAsOne) {
    // Each triangle with corners of its own, as in an STL file.
    const mesh::TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    mesh::TriangleMesh soup;
    for (const mesh::Triangle& t : box.triangles) {
        const auto first = static_cast<std::int32_t>(soup.vertices.size());
        for (const std::int32_t v : t) {
            soup.vertices.push_back(box.vertices[static_cast<std::size_t>(v)]);
        }
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const MeshDistance joined(box), loose(soup);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-1.0, 2.0);
    for (int k = 0; k < 1000; ++k) {
        const Vec3 p(place(random), place(random), place(random));
        EXPECT_EQ(joined.at(p, -1).value, loose.at(p, -1).value);
    }
}

}  // namespace
}  // namespace mq::inspection
