// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/given_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"

namespace mq::given {
namespace {

/// Two tetrahedra on either side of the triangle (1, 2, 3).
GivenMesh pair() {
    GivenMesh mesh;
    mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    mesh.tetrahedra = {{0, 1, 2, 3}, {4, 1, 3, 2}};
    return mesh;
}

double six_volumes(const GivenMesh& mesh, const std::vector<std::array<int, 3>>& surface) {
    double sum = 0.0;
    for (const auto& t : surface) {
        const auto at = [&](std::size_t k) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(t[k])]; };
        sum += at(0).dot(at(1).cross(at(2)));
    }
    return sum;
}

TEST(GivenMesh, FacesOfATetrahedronLookOutward) {
    GivenMesh one = pair();
    one.tetrahedra.pop_back();
    const auto surface = surface_of(one);
    EXPECT_EQ(surface.size(), 4u);
    EXPECT_DOUBLE_EQ(six_volumes(one, surface), 1.0);
}

TEST(GivenMesh, SharedTriangleIsInsideUnlessItIsListedOrLiesBetweenTwoBodies) {
    GivenMesh mesh = pair();
    EXPECT_EQ(surface_of(mesh).size(), 6u);
    mesh.triangles = {{3, 1, 2}};
    EXPECT_EQ(surface_of(mesh).size(), 7u);
    mesh.triangles.clear();
    mesh.regions = {7, 9};
    EXPECT_EQ(surface_of(mesh).size(), 7u);
}

TEST(GivenMesh, ListedTriangleThatIsNoFaceIsLeftOut) {
    GivenMesh mesh = pair();
    mesh.triangles = {{0, 1, 4}};
    EXPECT_EQ(surface_of(mesh).size(), 6u);
}

TEST(GivenMesh, InvertedTetrahedraAreNotTurned) {
    GivenMesh mesh = pair();
    mesh.nodes[4] = {-2, -2, -2};            // on the other side of the common triangle, beyond the first tetrahedron
    EXPECT_EQ(orient_tetrahedra(mesh), 2u);  // the second one is the larger
    EXPECT_EQ(orient_tetrahedra(mesh), 0u);
}

TEST(GivenMesh, TetrahedraOfTheOtherNumberingAreTurned) {
    GivenMesh mesh = pair();
    std::swap(mesh.tetrahedra[1][0], mesh.tetrahedra[1][1]);
    EXPECT_EQ(orient_tetrahedra(mesh), 1u);
    EXPECT_EQ(orient_tetrahedra(mesh), 0u);
    EXPECT_DOUBLE_EQ(six_volumes(mesh, surface_of(mesh)), 3.0);
}

TEST(GivenMesh, ThreeTetrahedraOnOneTriangleAreRefused) {
    GivenMesh mesh = pair();
    mesh.nodes.emplace_back(2, 2, 2);
    mesh.tetrahedra.push_back({5, 1, 3, 2});
    EXPECT_THROW(surface_of(mesh), InvalidInput);
}

TEST(GivenMesh, FaultsAreNamed) {
    const auto refused = [](const GivenMesh& mesh) -> std::string {
        try {
            require_sound(mesh);
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refused(pair()), "");
    EXPECT_NE(refused(GivenMesh{}).find("neither triangles nor tetrahedra"), std::string::npos);
    GivenMesh mesh = pair();
    mesh.tetrahedra[1][2] = 5;
    EXPECT_NE(refused(mesh).find("tetrahedron 1"), std::string::npos);
    mesh = pair();
    mesh.tetrahedra[1][2] = 4;
    EXPECT_NE(refused(mesh).find("one node twice"), std::string::npos);
    mesh = pair();
    mesh.nodes[0].x() = NAN;
    EXPECT_NE(refused(mesh).find("tetrahedron 0"), std::string::npos);
    mesh = pair();
    mesh.regions = {1};
    EXPECT_NE(refused(mesh).find("regions has 1 entries where 2 are needed"), std::string::npos);
}

}  // namespace
}  // namespace mq::given
