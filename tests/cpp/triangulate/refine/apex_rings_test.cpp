// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/apex_rings.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <gp_Ax2.hxx>
#include <gp_GTrsf.hxx>

#include "base/angle.h"
#include "triangulate/checks.h"

/// Around the apex of a slender cone few triangles have room, and their angles share the small total angle.
namespace mq::triangulate {
namespace {

constexpr double kHeight = 10.0;  // mm: height of the cones.

double shortest_edge(const mesh::TriangleMesh& mesh) {
    double shortest = 1e300;
    for (const mesh::Triangle& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            shortest = std::min(shortest, (mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm());
        }
    }
    return shortest;
}

/// Returns a half-edge that leaves the apex; -1: there is none.
int at_apex(const ClassifiedMesh& mesh) {
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        if (cone_fan(mesh, h)) {
            return h;
        }
    }
    return -1;
}

/// Without rings, refinement went on to the apex: up to 4,362 triangles, edges down to 1e-5 of the radius, 49 exempt
/// ones.
TEST(ApexRings, KeepConesCoarse) {
    for (const double radius : {0.25, 0.5, 1.0, 1.25, 2.0, 3.25, 4.5, 5.0, 5.5, 8.0, 12.0}) {
        for (const double angle : {25.0, 30.0}) {
            SCOPED_TRACE(testing::Message() << radius << " at " << angle);
            TriangulateOptions options;
            options.min_angle = angle;
            const Result result = mesh_of(geometry::make_cone(radius, kHeight), options);
            expect_sound(result, 2, true);
            expect_angles(result, angle);
            EXPECT_LE(result.report.exempt.size(), 3u);
            EXPECT_LE(result.mesh.triangles.size(), radius < 0.5 ? 500u : 350u);
            EXPECT_GT(shortest_edge(result.mesh), 0.05 * radius);
        }
    }
}

/// A chord that spans a third of the turn keeps the chord tolerance only near the apex. A ring farther out would be
/// divided.
TEST(ApexRings, KeepTheChordHeight) {
    for (const double radius : {1.0, 2.25, 5.0}) {
        SCOPED_TRACE(radius);
        TriangulateOptions options;
        options.chord_height = 1e-3 * kHeight;
        const Result result = mesh_of(geometry::make_cone(radius, kHeight), options);
        expect_sound(result, 2, true);
        expect_angles(result, 25.0);
        EXPECT_LE(result.report.max_chord_height, options.chord_height);
        EXPECT_LE(result.mesh.triangles.size(), 4000u);
    }
}

/// The initial triangles lie deep below the cone: rings that kept the chord tolerance at once crowded around the apex,
/// with 58,014 triangles, 766 of them exempt.
TEST(ApexRings, StayAwayFromTheApexInACoarseStart) {
    TriangulateOptions options;
    options.min_angle = 30.0;
    options.chord_height = 2e-3 * kHeight;
    const Result result = mesh_of(geometry::make_cone(4.3, kHeight), options);
    expect_sound(result, 2, true);
    expect_angles(result, options.min_angle);
    EXPECT_LE(result.report.max_chord_height, options.chord_height);
    EXPECT_LE(result.report.exempt.size(), 3u);
    EXPECT_LE(result.mesh.triangles.size(), 3000u);
}

TEST(ApexRings, PutVerticesAtOneDistance) {
    for (const double radius : {1.0, 3.0, 5.0}) {
        SCOPED_TRACE(radius);
        Pipeline pipeline(geometry::make_cone(radius, kHeight));
        SegmentSplitter segments(pipeline.work);
        ApexRings rings(pipeline.work, segments, 25.0 * kDegree, 0.0);
        const ClassifiedMesh& mesh = pipeline.surface;
        const int h = at_apex(mesh);
        ASSERT_GE(h, 0);
        const int vertex = mesh.vertex_of(h);
        const int before = mesh.vertex_count();
        const std::size_t triangles = cone_fan(mesh, h)->triangles;
        std::vector<int> touched;
        EXPECT_TRUE(rings.insert_ring(h, touched));
        EXPECT_FALSE(touched.empty());
        ASSERT_GE(mesh.vertex_count(), before + 3);
        const auto away = [&](int v) { return (mesh.vertex(v).point - mesh.vertex(vertex).point).norm(); };
        for (int v = before; v < mesh.vertex_count(); ++v) {
            EXPECT_NEAR(away(v), away(before), 0.05 * away(before));
        }
        EXPECT_LT(cone_fan(mesh, at_apex(mesh))->triangles, std::max<std::size_t>(triangles, 7));
        EXPECT_EQ(mesh.inconsistency(), "");
        expect_on_curves(pipeline);
    }
}

TEST(ApexRings, LeaveOtherVerticesAlone) {
    for (const auto& model :
         {geometry::make_box(1.0, 2.0, 3.0), geometry::make_sphere(1.0), geometry::make_cone(20.0, kHeight)}) {
        Pipeline pipeline(model);
        SegmentSplitter segments(pipeline.work);
        ApexRings rings(pipeline.work, segments, 25.0 * kDegree, 0.0);
        std::vector<int> touched;
        for (int h = 0; h < pipeline.surface.half_edge_count(); ++h) {
            EXPECT_FALSE(rings.insert_ring(h, touched));
        }
        EXPECT_TRUE(touched.empty());
    }
}

/// The seam that ends there is split where a ring requests it and nowhere else.
TEST(ApexRings, AloneSplitTheSeam) {
    Pipeline pipeline(geometry::make_cone(2.0, kHeight));
    ClassifiedMesh& mesh = pipeline.surface;
    const int h = at_apex(mesh);
    ASSERT_GE(h, 0);
    const int apex = mesh.vertex_of(h);
    const int seam = mesh.segment_of(mesh.star(h).front());
    ASSERT_GE(seam, 0);
    EXPECT_TRUE(SegmentSplitter(pipeline.work, false).may_split(seam));
    SegmentSplitter segments(pipeline.work);
    EXPECT_FALSE(segments.may_split(seam));
    segments.request(seam);
    EXPECT_TRUE(segments.idle());
    segments.request_at(seam, mesh.segment(seam).vertices[0] == apex ? 0 : 1, 3.0);
    std::vector<int> touched;
    segments.run(touched);
    const int added = mesh.vertex_count() - 1;
    EXPECT_NEAR((mesh.vertex(added).point - mesh.vertex(apex).point).norm(), 3.0, 1e-5);
}

/// At the sharp ends of a flat ellipse chords of a ring would lie deep below the surface. Refinement continues without
/// rings.
TEST(ApexRings, GiveUpWhereTheyDoNotHelp) {
    for (const double flat : {0.5, 0.3}) {
        SCOPED_TRACE(flat);
        gp_GTrsf flatten;
        flatten.SetValue(2, 2, flat);
        const TopoDS_Shape round = BRepPrimAPI_MakeCone(1.4, 0.0, kHeight).Shape();
        const Result result =
            mesh_of(geometry::make_shape_model(BRepBuilderAPI_GTransform(round, flatten, true).Shape()));
        expect_sound(result, 2, true);
        expect_angles(result, 25.0);
        EXPECT_LT(result.report.exempt.size(), 0.05 * result.mesh.triangles.size());
    }
}

/// Two cones on one base.
TEST(ApexRings, KeepTheirApexesApart) {
    const TopoDS_Shape up = BRepPrimAPI_MakeCone(3.0, 0.0, kHeight).Shape();
    const TopoDS_Shape down = BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, -1)), 4.5, 0.0, 20.0).Shape();
    const Result result = mesh_of(geometry::make_shape_model(BRepAlgoAPI_Fuse(up, down).Shape()));
    expect_sound(result, 2, true);
    expect_angles(result, 25.0);
    EXPECT_LE(result.report.exempt.size(), 6u);
    EXPECT_LE(result.mesh.triangles.size(), 400u);
}

}  // namespace
}  // namespace mq::triangulate
