// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/incremental/cache_restore.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakePrism.hxx>

#include "triangulate/checks.h"
#include "triangulate/incremental/remeshing.h"

/// Meshing a shape again after an edit.
namespace mq::triangulate {
namespace {

constexpr int kAlong = 6;        // Holes along one direction of the plate.
constexpr int kAcross = 6;       // Holes along the other direction.
constexpr double kPitch = 10.0;  // mm, between the centres of holes.

/// A plate with 36 holes, every other one blind: 60 faces. The radius of the first hole is a parameter.
std::shared_ptr<geometry::Model> plate(double first_radius) {
    TopoDS_Compound holes;
    BRep_Builder builder;
    builder.MakeCompound(holes);
    for (int i = 0; i < kAlong; ++i) {
        for (int j = 0; j < kAcross; ++j) {
            const double radius = i == 0 && j == 0 ? first_radius : 2.0 + 0.1 * ((i + 3 * j) % 7);
            const gp_Ax2 axis(gp_Pnt(kPitch * (i + 0.5), kPitch * (j + 0.5), -1.0), gp_Dir(0.0, 0.0, 1.0));
            builder.Add(holes, BRepPrimAPI_MakeCylinder(axis, radius, (i + j) % 2 == 0 ? 12.0 : 6.0).Shape());
        }
    }
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(kPitch * kAlong, kPitch * kAcross, 10.0).Shape();
    return geometry::make_shape_model(BRepAlgoAPI_Cut(block, holes).Shape());
}

TriangulateOptions asked() {
    TriangulateOptions options;
    options.chord_height = 0.02;
    return options;
}

void expect_guarantees(const Result& result, const TriangulateOptions& options) {
    const mesh::MeshReport measured = mesh::measure(result.mesh);
    EXPECT_TRUE(measured.closed);
    EXPECT_TRUE(measured.oriented);
    EXPECT_TRUE(measured.manifold);
    EXPECT_EQ(result.report.self_intersections, 0);
    EXPECT_GE(result.report.min_angle_unexempted, options.min_angle);
    EXPECT_TRUE(result.report.exempt.empty());
    EXPECT_LE(result.report.max_chord_height, options.chord_height);
}

TEST(CacheRestore, StatesMetAgainGetTheirMeshAgain) {
    MeshCache memory;
    const Result first = run(plate(2.0), asked(), memory);
    EXPECT_EQ(first.report.reused_faces, 0U);
    const Result edited = run(plate(2.5), asked(), memory);
    const Result further = run(plate(2.2), asked(), memory);
    EXPECT_EQ(memory.runs(), 3U);
    for (int round = 0; round < 2; ++round) {  // undo and redo
        expect_same(run(plate(2.5), asked(), memory), edited);
        expect_same(run(plate(2.0), asked(), memory), first);
        expect_same(run(plate(2.2), asked(), memory), further);
    }
    EXPECT_EQ(memory.runs(), 3U);
    EXPECT_EQ(run(plate(2.0), asked(), memory).report.reused_faces, plate(2.0)->topology().faces.size());
}

TEST(CacheRestore, OtherOptionsAreAnotherState) {
    MeshCache memory;
    const Result first = run(plate(2.0), asked(), memory);
    TriangulateOptions coarser = asked();
    coarser.chord_height = 0.05;
    const Result again = run(plate(2.0), coarser, memory);
    EXPECT_EQ(again.report.reused_faces, 0U);
    EXPECT_EQ(again.mesh.vertices, mesh_of(plate(2.0), coarser).mesh.vertices);
    expect_same(run(plate(2.0), asked(), memory), first);
}

TEST(CacheRestore, AnEditOfOneHoleLeavesTheOthers) {
    MeshCache memory;
    run(plate(2.0), asked(), memory);
    const auto edited = plate(2.5);
    const Result again = run(edited, asked(), memory);
    expect_guarantees(again, asked());
    // The wall of the hole, and the two faces that it goes through, are meshed again.
    EXPECT_GE(again.report.reused_faces + 8, edited->topology().faces.size());
    MeshCache other;
    run(plate(2.0), asked(), other);
    expect_same(run(edited, asked(), other), again);
}

TEST(CacheRestore, EditsBackAndForthKeepTheGuarantees) {
    MeshCache memory;
    for (const double radius : {2.0, 2.5, 3.0, 2.1}) {
        expect_guarantees(run(plate(radius), asked(), memory), asked());
    }
}

/// Plane, cone, torus and sphere faces: a block with a cone on it, a groove around that, and a dimple.
TopoDS_Shape ornament(double dimple) {
    const gp_Ax2 middle(gp_Pnt(10.0, 10.0, 5.0), gp_Dir(0.0, 0.0, 1.0));
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(20.0, 20.0, 5.0).Shape();
    const TopoDS_Shape with_cone = BRepAlgoAPI_Fuse(block, BRepPrimAPI_MakeCone(middle, 3.0, 1.0, 4.0).Shape());
    const TopoDS_Shape with_groove = BRepAlgoAPI_Cut(with_cone, BRepPrimAPI_MakeTorus(middle, 6.0, 1.0).Shape());
    return BRepAlgoAPI_Cut(with_groove, BRepPrimAPI_MakeSphere(gp_Pnt(2.5, 2.5, 5.0), dimple).Shape());
}

class RecallOnSurfaces : public testing::TestWithParam<bool> {
  protected:
    static TopoDS_Shape part(double dimple) {
        const TopoDS_Shape shape = ornament(dimple);
        return GetParam() ? BRepBuilderAPI_NurbsConvert(shape).Shape() : shape;
    }
};

TEST_P(RecallOnSurfaces, AnEditLeavesTheOthers) {
    MeshCache memory;
    run(geometry::make_shape_model(part(1.0)), asked(), memory);
    for (const double dimple : {1.3, 0.7}) {
        const auto edited = geometry::make_shape_model(part(dimple));
        const Result again = run(edited, asked(), memory);
        expect_guarantees(again, asked());
        // The cone's faces; all others share edges with the top, which has changed.
        EXPECT_GE(again.report.reused_faces, 3U);
    }
}

TEST_P(RecallOnSurfaces, APartThatIsMovedTakesItsFacesAlong) {
    MeshCache memory;
    const TopoDS_Shape shape = part(1.0);
    const Result first = run(geometry::make_shape_model(shape), asked(), memory);
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(3.0, 2.0, 1.0), gp_Dir(1.0, 2.0, 0.5)), 1.1);
    gp_Trsf shift;
    shift.SetTranslation(gp_Vec(50.0, -20.0, 7.0));
    gp_Trsf far;
    far.SetTranslation(gp_Vec(1e6, 0.0, 0.0));
    for (const gp_Trsf& motion : {shift, turn, far}) {
        const auto moved = geometry::make_shape_model(shape.Moved(TopLoc_Location(motion)));
        const Result again = run(moved, asked(), memory);
        expect_guarantees(again, asked());
        EXPECT_GE(again.report.reused_faces + 2, moved->topology().faces.size());
        EXPECT_LE(again.mesh.triangles.size(), 1.05 * first.mesh.triangles.size());
    }
    expect_same(run(geometry::make_shape_model(shape), asked(), memory), first);
}

/// A prism over a triangle with a corner of 4.3 degrees, on which no mesh reaches the angle bound.
TopoDS_Shape blade() {
    BRepBuilderAPI_MakePolygon outline(gp_Pnt(0.0, 0.0, 0.0), gp_Pnt(40.0, 0.0, 0.0), gp_Pnt(40.0, 3.0, 0.0), true);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0.0, 0.0, 30.0)).Shape();
}

/// Exempt triangles were tried again in each run, with ever more triangles around them: 160, 170, 316, 426.
TEST(CacheRestore, WhatWasGivenUpGoesAlongToo) {
    TriangulateOptions options;
    options.chord_height_relative = 0.003;
    MeshCache memory;
    const Result first = run(geometry::make_shape_model(blade()), options, memory);
    ASSERT_FALSE(first.report.exempt.empty());
    gp_Trsf motion;
    gp_Trsf step;
    step.SetTranslation(gp_Vec(3.0, -2.0, 1.0));
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(3.0, 2.0, 1.0), gp_Dir(1.0, 2.0, 0.5)), 0.7);
    for (int i = 0; i < 6; ++i) {
        motion = (i % 2 == 0 ? step : turn) * motion;
        const auto moved = geometry::make_shape_model(blade().Moved(TopLoc_Location(motion)));
        const Result again = run(moved, options, memory);
        EXPECT_EQ(again.mesh.triangles.size(), first.mesh.triangles.size());
        EXPECT_EQ(again.report.reused_faces, moved->topology().faces.size());
        EXPECT_EQ(again.report.exempt.size(), first.report.exempt.size());
        EXPECT_EQ(mesh::message_of(again.report.exempt.front().second).text(),
                  mesh::message_of(first.report.exempt.front().second).text());
        EXPECT_GE(again.report.min_angle_unexempted, options.min_angle);
        EXPECT_TRUE(again.report.closed && again.report.oriented && again.report.manifold);
    }
}

/// On this shape all faces are beside the hole, or beside such faces: cached triangles had to be replaced, and one
/// mesh had 506 triangles where meshing from scratch gives 344.
TEST(CacheRestore, EditsDoNotMakeASharpPartGrow) {
    TriangulateOptions options;
    options.chord_height = 0.05;
    MeshCache memory;
    for (int number = 0; number < 6; ++number) {
        const gp_Ax2 axis(gp_Pnt(30.0 + number, 1.0, 15.0 - number), gp_Dir(0.0, 1.0, 0.0));
        const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(axis, 1.0, 10.0).Shape();
        const auto part = geometry::make_shape_model(BRepAlgoAPI_Cut(blade(), hole).Shape());
        const Result last = run(part, options, memory);
        const Result nothing = mesh_of(part, options);
        EXPECT_LE(last.mesh.triangles.size(), 1.15 * nothing.mesh.triangles.size()) << "edit " << number;
        EXPECT_LE(last.report.exempt.size(), nothing.report.exempt.size() + 2) << "edit " << number;
    }
}

INSTANTIATE_TEST_SUITE_P(AnalyticAndSplines, RecallOnSurfaces, testing::Bool());

/// Nine holes, and a very small one right beside one of them.
std::shared_ptr<geometry::Model> plate_with_detail(int number) {
    TopoDS_Compound holes;
    BRep_Builder builder;
    builder.MakeCompound(holes);
    const gp_Dir up(0.0, 0.0, 1.0);
    for (int i = 0; i < 9; ++i) {
        const gp_Pnt centre(kPitch * (i % 3 + 0.5), kPitch * (i / 3 + 0.5), -1.0);
        builder.Add(holes, BRepPrimAPI_MakeCylinder(gp_Ax2(centre, up), 2.0, 12.0).Shape());
        if (i == number % 9) {
            const gp_Pnt beside = centre.Translated(gp_Vec(2.1 * std::cos(number), 2.1 * std::sin(number), 0.0));
            builder.Add(holes, BRepPrimAPI_MakeCylinder(gp_Ax2(beside, up), 0.05, 12.0).Shape());
        }
    }
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(3 * kPitch, 3 * kPitch, 10.0).Shape();
    return geometry::make_shape_model(BRepAlgoAPI_Cut(block, holes).Shape());
}

TEST(CacheRestore, ThirtyEditsDoNotMakeTheMeshGrow) {
    TriangulateOptions options;
    options.chord_height = 0.05;
    MeshCache memory;
    std::size_t reused = 0;
    for (int number = 0; number <= 30; ++number) {
        const auto part = plate_with_detail(number);
        const Result last = run(part, options, memory);
        reused += last.report.reused_faces;
        if (number % 10 == 0) {
            expect_guarantees(last, options);
            const Result nothing = mesh_of(part, options);
            EXPECT_LE(last.mesh.triangles.size(), 1.15 * nothing.mesh.triangles.size()) << "edit " << number;
        }
    }
    // The mesh has 16 faces, of which the wall of the small hole and both sides change each time.
    EXPECT_GT(reused, 30U * 5U);
}

TEST(CacheRestore, SmallChangesOfTheToleranceDoNotAddUp) {
    MeshCache memory;
    TriangulateOptions options;
    const auto part = geometry::make_shape_model(ornament(1.0));
    std::size_t reused = 0;
    for (options.chord_height = 0.002; options.chord_height < 0.05; options.chord_height *= 1.2) {
        const Result last = run(part, options, memory);
        expect_guarantees(last, options);
        reused += last.report.reused_faces;
        EXPECT_LE(last.mesh.triangles.size(), 1.35 * mesh_of(part, options).mesh.triangles.size());
    }
    EXPECT_GT(reused, 0U);
}

TEST(CacheRestore, LocalSizesBelongToTheFace) {
    MeshCache memory;
    TriangulateOptions options = asked();
    const auto top = [](const geometry::Model& part) {  // face numbers change from edit to edit
        int best = -1;
        const auto& faces = part.topology().faces;
        for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
            if (best < 0 || faces[f].loops.size() > faces[best].loops.size()) {
                best = f;
            }
        }
        return best;
    };
    for (const double dimple : {1.0, 1.2}) {
        const auto part = geometry::make_shape_model(ornament(dimple));
        options.local_sizes = {{2, top(*part), 0.5}};
        const Result result = run(part, options, memory);
        expect_guarantees(result, options);
        for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
            const auto corners = corners_of(result.mesh, t);
            for (int k = 0; result.mesh.triangle_face[t] == top(*part) && k < 3; ++k) {
                ASSERT_LE((corners[k] - corners[(k + 1) % 3]).norm(), 0.5 + 1e-9);
            }
        }
        options.local_sizes = {{2, top(*part) == 0 ? 1 : 0, 0.5}};
        EXPECT_LT(run(part, options, memory).report.reused_faces, part->topology().faces.size());
    }
}

TEST(CacheRestore, OtherSettingsKeepTheGuarantees) {
    TriangulateOptions graded = asked();
    graded.growth = 1.5;
    TriangulateOptions round = asked();
    round.edges_per_circle = 24.0;
    TriangulateOptions paper = asked();
    paper.insertion = Insertion::Circumcentre;
    TriangulateOptions released = asked();
    released.keep_edges = KeepEdges::Feature;
    TriangulateOptions sampled = asked();
    sampled.method = Method::Star;
    for (const TriangulateOptions& options : {graded, round, paper, released, sampled}) {
        MeshCache memory;
        const Result first = run(geometry::make_shape_model(ornament(1.0)), options, memory);
        const Result again = run(geometry::make_shape_model(ornament(1.3)), options, memory);
        if (options.keep_edges == KeepEdges::All && options.method == Method::Refine) {
            expect_guarantees(again, options);
            EXPECT_GT(again.report.reused_faces, 0U);
        } else {
            expect_same(again, mesh_of(geometry::make_shape_model(ornament(1.3)), options));
        }
        expect_same(run(geometry::make_shape_model(ornament(1.0)), options, memory), first);
    }
}

}  // namespace
}  // namespace mq::triangulate
