// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/output/curved_mesh.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "base/error.h"
#include "curve/files.h"

namespace mq::curve {
namespace {

/// One tetrahedron of order 1 with one of its triangles and an edge.
CurvedMesh tetrahedron() {
    CurvedMesh mesh;
    mesh.nodes = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    mesh.node_entity = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
    mesh.edges = {0, 1};
    mesh.edge_entity = {0};
    mesh.triangles = {0, 2, 1};
    mesh.triangle_face = {0};
    mesh.triangle_quality = {1.0};
    mesh.tetrahedra = {0, 1, 2, 3};
    mesh.tetrahedron_volume = {0};
    mesh.tetrahedron_quality = {1.0};
    return mesh;
}

void expect_refused(const std::function<void(CurvedMesh&)>& spoil, const std::string& words) {
    CurvedMesh mesh = tetrahedron();
    spoil(mesh);
    try {
        require_sound(mesh);
        ADD_FAILURE() << "accepted: " << words;
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(SoundCurvedMesh, IsAcceptedAndWritten) {
    CurvedMesh mesh = tetrahedron();
    EXPECT_NO_THROW(require_sound(mesh));
    EXPECT_NE(to_msh(mesh).find("3 1 \"Solid1\""), std::string::npos);
    mesh.triangle_quality.clear();
    mesh.tetrahedron_quality.clear();
    EXPECT_NO_THROW(require_sound(mesh));
}

TEST(SoundCurvedMesh, HasKnownEntities) {
    constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
    expect_refused([](CurvedMesh& m) { m.node_entity[1] = {100, 0}; }, "a node lies on entity 0 of dimension 100");
    expect_refused([](CurvedMesh& m) { m.node_entity[1] = {-1, -1}; }, "a node lies on entity -1 of dimension -1");
    expect_refused([](CurvedMesh& m) { m.node_entity[1] = {2, kLargest}; }, "entity 2147483647 of dimension 2");
    expect_refused([](CurvedMesh& m) { m.edge_entity[0] = -1; }, "an edge lies on entity -1");
    expect_refused([](CurvedMesh& m) { m.triangle_face[0] = kLargest; }, "a triangle lies on entity 2147483647");
    expect_refused([](CurvedMesh& m) { m.tetrahedron_volume[0] = -7; }, "a tetrahedron lies on entity -7");
    expect_refused([](CurvedMesh& m) { m.node_entity.pop_back(); }, "node_entity has 3 entries where 4 are needed");
}

TEST(SoundCurvedMesh, HasWholeElementsOfKnownFiniteNodes) {
    expect_refused([](CurvedMesh& m) { m.order = 0; }, "an order of 1 to 5, not 0");
    expect_refused([](CurvedMesh& m) { m.order = 6; }, "an order of 1 to 5, not 6");
    expect_refused([](CurvedMesh& m) { m.nodes[2].y() = std::numeric_limits<double>::quiet_NaN(); },
                   "node 2 has a coordinate that is not a finite number");
    expect_refused([](CurvedMesh& m) { m.nodes[2].y() = 1e163; },
                   "coordinates that are not finite or above 1.8e+19 mm");
    expect_refused([](CurvedMesh& m) { m.triangles[0] = 4; }, "triangles name node 4, but the mesh has 4 nodes");
    expect_refused([](CurvedMesh& m) { m.edges.pop_back(); }, "edges of order 1 have 2 nodes each: 1 are given for 1");
    expect_refused([](CurvedMesh& m) { m.tetrahedra[3] = -1; }, "tetrahedra name node -1");
}

TEST(SoundCurvedMesh, HasOneQualityEach) {
    expect_refused([](CurvedMesh& m) { m.triangle_quality.push_back(1.0); }, "triangle_quality has 2 entries where 1");
    expect_refused([](CurvedMesh& m) { m.tetrahedron_quality.push_back(1.0); },
                   "tetrahedron_quality has 2 entries where 1");
}

}  // namespace
}  // namespace mq::curve
