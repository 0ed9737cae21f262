// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/components/placed_body.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCone.hxx>
#include <numeric>

#include "geometry/assemblies.h"
#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

using geometry::at_place;

/// Two equal cones with their initial meshes.
class TwoCones : public testing::Test {
  protected:
    TwoCones()
        : pipeline_(geometry::make_shape_model(geometry::compound_of({cone_, at_place(cone_, 9.0, 0.7)}))),
          bodies_(bodies_of(pipeline_.surface, {0, 0, 0, 1, 1, 1},
                            std::vector<double>(static_cast<std::size_t>(pipeline_.surface.triangle_count()), 1.0))),
          equal_(find_equal_bodies(pipeline_.session, {{0, 1, 2}, {3, 4, 5}},
                                   [](geometry::Entity, geometry::Fingerprint&) {})) {}

    const std::vector<int>& triangles(int face) const {
        const auto has = [&](const MeshBody& body) {
            return pipeline_.surface.face_of(body.triangles.front()) / 3 == face / 3;
        };
        return std::find_if(bodies_.begin(), bodies_.end(), has)->triangles;
    }

    bool add(const ClassifiedMesh& original, MeshComponent& component) {
        return add_placed(pipeline_.session, pipeline_.grid, original, equal_, 1, pipeline_.surface,
                          vertices_of_nodes(pipeline_.surface, triangles(3)), component);
    }

    TopoDS_Shape cone_ = BRepPrimAPI_MakeCone(2.0, 1.0, 5.0).Shape();
    Pipeline pipeline_;
    std::vector<MeshBody> bodies_;
    EqualBodies equal_;
};

TEST_F(TwoCones, TheCopyHasTheMovedMesh) {
    ASSERT_EQ(bodies_.size(), 2U);
    const ClassifiedMesh original = component_of(pipeline_.surface, triangles(0)).mesh;
    MeshComponent placed;
    ASSERT_TRUE(add(original, placed));
    EXPECT_EQ(placed.mesh.inconsistency(), "");
    ASSERT_EQ(placed.mesh.triangle_count(), original.triangle_count());
    ASSERT_EQ(placed.vertices.size(), static_cast<std::size_t>(original.vertex_count()));
    int nodes = 0;
    for (int v = 0; v < original.vertex_count(); ++v) {
        const Vec3 moved = equal_.motion[1].of_point(pipeline_.grid.to_shape(original.vertex(v).point));
        const Vec3 point = placed.mesh.vertex(v).point;
        EXPECT_LE((pipeline_.grid.to_shape(point) - moved).norm(), 2.0 * pipeline_.grid.resolution());
        EXPECT_EQ(point, pipeline_.grid.snap(pipeline_.grid.to_shape(point)));
        EXPECT_EQ(placed.mesh.vertex(v).entity[0], original.vertex(v).entity[0]);
        const int former = placed.vertices[static_cast<std::size_t>(v)];
        EXPECT_EQ(former >= 0, original.vertex(v).entity[0] == 0);
        if (former >= 0) {
            ++nodes;
            EXPECT_EQ(point, pipeline_.surface.vertex(former).point);
            EXPECT_EQ(placed.mesh.vertex(v).entity, pipeline_.surface.vertex(former).entity);
        }
    }
    EXPECT_EQ(nodes, 2);
    for (int t = 0; t < original.triangle_count(); ++t) {
        EXPECT_EQ(placed.mesh.face_of(t), original.face_of(t) + 3);
    }
}

TEST_F(TwoCones, TheSecondCopyFollowsTheFirst) {
    const ClassifiedMesh original = component_of(pipeline_.surface, triangles(0)).mesh;
    MeshComponent placed;
    ASSERT_TRUE(add(original, placed));
    ASSERT_TRUE(add(original, placed));
    EXPECT_EQ(placed.mesh.inconsistency(), "");
    EXPECT_EQ(placed.mesh.triangle_count(), 2 * original.triangle_count());
    EXPECT_EQ(placed.mesh.point_of(3 * original.triangle_count()), placed.mesh.point_of(0));
}

TEST_F(TwoCones, NothingIsPlacedWhereTheModelIsNot) {
    const ClassifiedMesh original = component_of(pipeline_.surface, triangles(0)).mesh;
    MeshComponent placed;
    equal_.motion[1].shift += Vec3(0.0, 10.0 * pipeline_.grid.resolution(), 0.0);
    EXPECT_FALSE(add(original, placed));
    EXPECT_EQ(placed.mesh.vertex_count(), 0);
    EXPECT_EQ(placed.mesh.triangle_count(), 0);
}

/// The ring of vertices between two nodes of an edge has been turned: nodes are right, and points on edges are not.
TEST_F(TwoCones, NothingIsPlacedWherePointsOnEdgesAreOthers) {
    ClassifiedMesh original;
    MeshComponent component = component_of(pipeline_.surface, triangles(0));
    for (int v = 0; v < component.mesh.vertex_count(); ++v) {
        const ClassifiedMesh::Vertex vertex = component.mesh.vertex(v);
        const Vec3 raised = vertex.point + Vec3(0.0, 0.0, 1e-3);
        original.add_vertex(vertex.entity[0] == 1 ? raised : vertex.point, vertex.entity);
    }
    for (int s = 0; s < component.mesh.site_count(); ++s) {
        original.add_site(component.mesh.site(s));
    }
    for (int t = 0; t < component.mesh.triangle_count(); ++t) {
        original.add_triangle(
            {component.mesh.site_of(3 * t), component.mesh.site_of(3 * t + 1), component.mesh.site_of(3 * t + 2)},
            component.mesh.face_of(t));
    }
    for (int s = 0; s < component.mesh.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = component.mesh.segment(s);
        original.add_segment(segment.edge, segment.vertices, segment.t);
    }
    MeshComponent placed;
    EXPECT_FALSE(add(original, placed));
}

/// A triangle so small that rounding could give it any shape.
TEST_F(TwoCones, NothingIsPlacedWhereATriangleBecomesALine) {
    ClassifiedMesh original;
    for (int i = 0; i < 3; ++i) {
        original.add_vertex(Vec3(1.0, 1.0, 1.0), {2, 0});
        original.add_site({i, Vec2::Zero(), Vec3(0.0, 0.0, 1.0)});
    }
    original.add_triangle({0, 1, 2}, 0);
    MeshComponent placed;
    EXPECT_FALSE(add(original, placed));
}

}  // namespace
}  // namespace mq::triangulate
