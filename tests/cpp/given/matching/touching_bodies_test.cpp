// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/touching_bodies.h"

#include <gtest/gtest.h>

#include <set>

#include "curve/volume/tetrahedral_mesh.h"

namespace mq::given {
namespace {

/// The surface of tetrahedra that share nodes.
GivenMesh surfaces_of(std::vector<Vec3> nodes, const std::vector<std::array<int, 4>>& tetrahedra) {
    GivenMesh mesh;
    mesh.nodes = std::move(nodes);
    for (const auto& corners : tetrahedra) {
        for (const auto& face : curve::outward_faces(corners)) {
            mesh.triangles.push_back(face);
        }
    }
    return mesh;
}

/// By body of four triangles each: its nodes.
std::vector<std::set<int>> nodes_of_bodies(const GivenMesh& mesh) {
    std::vector<std::set<int>> result(mesh.triangles.size() / 4);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        result[t / 4].insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
    return result;
}

void expect_separate(GivenMesh mesh, std::size_t copies) {
    const GivenMesh before = mesh;
    const std::vector<int> original = separate_touching_bodies(mesh);
    ASSERT_EQ(original.size(), mesh.nodes.size());
    EXPECT_EQ(mesh.nodes.size(), before.nodes.size() + copies);
    std::set<int> met;
    for (const std::set<int>& body : nodes_of_bodies(mesh)) {
        EXPECT_EQ(body.size(), 4u);
        for (const int node : body) {
            EXPECT_TRUE(met.insert(node).second);
        }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto node = static_cast<std::size_t>(mesh.triangles[t][k]);
            EXPECT_EQ(original[node], before.triangles[t][k]);
            EXPECT_EQ(mesh.nodes[node], before.nodes[static_cast<std::size_t>(before.triangles[t][k])]);
        }
    }
}

TEST(TouchingBodies, InANodeHaveACopyOfIt) {
    expect_separate(surfaces_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                                {{0, 1, 2, 3}, {0, 5, 4, 6}}),
                    1);
}

TEST(TouchingBodies, InAnEdgeHaveCopiesOfItsNodes) {
    expect_separate(
        surfaces_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 2, 3, 1}, {0, 4, 5, 1}}),
        2);
}

TEST(TouchingBodies, InATriangleHaveCopiesOfItsNodes) {
    expect_separate(surfaces_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}}, {{0, 1, 2, 3}, {0, 2, 1, 4}}),
                    3);
}

TEST(TouchingBodies, AllAroundAnEdgeAreSeparated) {
    // Four tetrahedra at the edge of nodes 0 and 1, each beside the next.
    expect_separate(surfaces_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                                {{0, 2, 3, 1}, {0, 3, 4, 1}, {0, 4, 5, 1}, {0, 5, 2, 1}}),
                    10);
}

TEST(TouchingBodies, TrianglesWithoutOrderAroundAnEdgeStayTogether) {
    GivenMesh mesh;
    mesh.nodes = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    EXPECT_EQ(separate_touching_bodies(mesh).size(), 5u);
    EXPECT_EQ(mesh.nodes.size(), 5u);
}

TEST(TouchingBodies, TetrahedraStayTogether) {
    GivenMesh mesh;
    mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    mesh.tetrahedra = {{0, 1, 2, 3}, {0, 5, 4, 6}};
    EXPECT_EQ(separate_touching_bodies(mesh).size(), 7u);
}

}  // namespace
}  // namespace mq::given
