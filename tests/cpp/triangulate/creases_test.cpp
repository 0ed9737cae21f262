// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/error.h"
#include "geometry/creased_shapes.h"
#include "geometry/occt/shape_model.h"
#include "triangulate/checks.h"
#include "triangulate/incremental/mesh_cache.h"

namespace mq::triangulate {
namespace {

using geometry::Creases;

Result cut_and_mesh(const TopoDS_Shape& shape, const TriangulateOptions& options = {}) {
    return mesh_of(geometry::make_shape_model(shape, nullptr, Creases::Cut), options);
}

TEST(CreasedParts, KeepTheirShapeExactly) {
    TriangulateOptions options;
    options.max_edge = 1.0;
    const Result result = cut_and_mesh(geometry::block_with_one_side(), options);
    EXPECT_TRUE(result.report.closed && result.report.oriented && result.report.manifold);
    EXPECT_TRUE(result.report.exempt.empty());
    EXPECT_NEAR(result.report.volume, 24.0, 1e-6);
    EXPECT_EQ(std::set<int>(result.mesh.triangle_face.begin(), result.mesh.triangle_face.end()),
              (std::set<int>{0, 1, 2}));
    for (const mesh::VertexEntity& entity : result.mesh.vertex_entity) {
        const int counts[3] = {2, 3, 3};
        EXPECT_LT(entity[1], counts[entity[0]]);
    }
}

TEST(CreasedParts, PatchesWithoutAreaLeaveNothingBehind) {
    for (const double angle : {25.0, 30.0}) {
        TriangulateOptions options;
        options.min_angle = angle;
        options.chord_height_relative = 0.001;
        const Result result = cut_and_mesh(geometry::wing_with_flat_ends(), options);
        EXPECT_TRUE(result.report.closed && result.report.oriented && result.report.manifold);
        EXPECT_EQ(result.report.self_intersections, 0);
        EXPECT_EQ(result.report.euler, 2);
        EXPECT_GE(result.report.min_angle_unexempted, angle);
        for (const auto& [triangle, why] : result.report.exempt) {
            EXPECT_EQ(why.cause, Cause::NarrowCorner) << mesh::message_of(why).text();
            EXPECT_NEAR(why.angle, 5.71, 0.01);
        }
        EXPECT_LE(result.report.max_chord_height, 0.024);
        EXPECT_TRUE(result.report.notes.empty()) << result.report.notes.front().text();
    }
}

TEST(CreasedParts, PatchesWithASideThatIsAPointAreCutInTheOrderThatKeepsTheirEdges) {
    TriangulateOptions options;
    options.min_angle = 25.0;
    options.chord_height_relative = 0.001;
    const Result result = cut_and_mesh(geometry::wing_with_a_sharp_middle(), options);
    EXPECT_TRUE(result.report.closed && result.report.oriented && result.report.manifold);
    EXPECT_EQ(result.report.self_intersections, 0);
    EXPECT_EQ(result.report.euler, 2);
    EXPECT_GE(result.report.min_angle_unexempted, 25.0);
    EXPECT_LE(result.report.max_chord_height, 0.024);
}

TEST(CreasedParts, LocalSizesHoldOnAllPieces) {
    TriangulateOptions options;
    options.local_sizes = {{2, 0, 0.3}};
    const Result result = cut_and_mesh(geometry::block_with_one_side(), options);
    double longest = 0.0;
    for (std::size_t i = 0; i < result.mesh.triangles.size(); ++i) {
        for (int k = 0; k < 3 && result.mesh.triangle_face[i] == 0; ++k) {
            const Vec3& a = result.mesh.vertices[static_cast<std::size_t>(result.mesh.triangles[i][k])];
            const Vec3& b = result.mesh.vertices[static_cast<std::size_t>(result.mesh.triangles[i][(k + 1) % 3])];
            longest = std::max(longest, (b - a).norm());
        }
    }
    EXPECT_GT(longest, 0.1);
    EXPECT_LE(longest, 0.3 + 1e-6);
    options.local_sizes = {{2, 3, 0.3}};  // index of a piece, but of no face of the shape
    EXPECT_THROW(cut_and_mesh(geometry::block_with_one_side(), options), InvalidInput);
}

TEST(CreasedParts, AreRememberedByTheirPieces) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    MeshCache memory;
    TriangulateOptions options;
    options.max_edge = 0.5;
    const auto run = [&](const TopoDS_Shape& shape) {
        return triangulate(engine, geometry::make_shape_model(shape, nullptr, Creases::Cut), options, nullptr, &memory);
    };
    const Result first = run(geometry::block_with_one_side());
    gp_Trsf shift;
    shift.SetTranslation(gp_Vec(1.0, 2.0, 3.0));
    const Result moved = run(geometry::block_with_one_side().Located(TopLoc_Location(shift)));
    EXPECT_EQ(moved.report.reused_faces, 3u);
    EXPECT_EQ(moved.mesh.triangles, first.mesh.triangles);
}

}  // namespace
}  // namespace mq::triangulate
