// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/recall.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>

#include "triangulate/checks.h"
#include "triangulate/memory.h"

/// Meshing a part again after an edit.
namespace mq::triangulate {
namespace {

constexpr int kAlong = 6;
constexpr int kAcross = 6;
constexpr double kPitch = 10.0;

/// A plate with 36 holes, every other one blind: 60 faces. The radius of the first hole is free.
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

Options asked() {
    Options options;
    options.chord_height = 0.02;
    return options;
}

Result run(const std::shared_ptr<geometry::Model>& model, const Options& options, Memory& memory) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    return triangulate(engine, model, options, nullptr, &memory);
}

void expect_guarantees(const Result& result, const Options& options) {
    const mesh::MeshReport measured = mesh::measure(result.mesh);
    EXPECT_TRUE(measured.closed);
    EXPECT_TRUE(measured.oriented);
    EXPECT_TRUE(measured.manifold);
    EXPECT_EQ(result.report.self_intersections, 0);
    EXPECT_GE(result.report.min_angle_unexempted, options.min_angle);
    EXPECT_TRUE(result.report.exempt.empty());
    EXPECT_LE(result.report.max_chord_height, options.chord_height);
}

void expect_same(const Result& a, const Result& b) {
    EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
    EXPECT_EQ(a.mesh.triangle_face, b.mesh.triangle_face);
    EXPECT_EQ(a.report.max_chord_height, b.report.max_chord_height);
    EXPECT_EQ(a.report.min_angle, b.report.min_angle);
    EXPECT_EQ(a.report.notes, b.report.notes);
}

TEST(Recall, StatesMetAgainGetTheirMeshAgain) {
    Memory memory;
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

TEST(Recall, OtherOptionsAreAnotherState) {
    Memory memory;
    const Result first = run(plate(2.0), asked(), memory);
    Options coarser = asked();
    coarser.chord_height = 0.05;
    const Result again = run(plate(2.0), coarser, memory);
    EXPECT_EQ(again.report.reused_faces, 0U);
    EXPECT_EQ(again.mesh.vertices, mesh_of(plate(2.0), coarser).mesh.vertices);
    expect_same(run(plate(2.0), asked(), memory), first);
}

TEST(Recall, AnEditOfOneHoleLeavesTheOthers) {
    Memory memory;
    run(plate(2.0), asked(), memory);
    const auto edited = plate(2.5);
    const Result again = run(edited, asked(), memory);
    expect_guarantees(again, asked());
    // The wall of the hole, and the two faces that it goes through.
    EXPECT_GE(again.report.reused_faces + 8, edited->topology().faces.size());
    Memory other;
    run(plate(2.0), asked(), other);
    expect_same(run(edited, asked(), other), again);
}

TEST(Recall, EditsBackAndForthKeepTheGuarantees) {
    Memory memory;
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
    Memory memory;
    run(geometry::make_shape_model(part(1.0)), asked(), memory);
    for (const double dimple : {1.3, 0.7}) {
        const auto edited = geometry::make_shape_model(part(dimple));
        const Result again = run(edited, asked(), memory);
        expect_guarantees(again, asked());
        EXPECT_GE(again.report.reused_faces, 3U);  // the cone's; all others share edges with the top, which is new
    }
}

TEST_P(RecallOnSurfaces, APartThatIsMovedTakesItsFacesAlong) {
    Memory memory;
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

TEST(Recall, ThirtyEditsDoNotMakeTheMeshGrow) {
    Options options;
    options.chord_height = 0.05;
    Memory memory;
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
    EXPECT_GT(reused, 30U * 5U);  // of 16 faces: the wall of the small hole and both sides are new each time
}

TEST(Recall, SmallChangesOfTheToleranceDoNotAddUp) {
    Memory memory;
    Options options;
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

TEST(Recall, LocalSizesBelongToTheFace) {
    Memory memory;
    Options options = asked();
    const auto top = [](const geometry::Model& part) {  // numbers change from edit to edit
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

TEST(Recall, OtherSettingsKeepTheGuarantees) {
    Options graded = asked();
    graded.growth = 1.5;
    Options round = asked();
    round.edges_per_circle = 24.0;
    Options paper = asked();
    paper.insertion = Insertion::Paper;
    Options released = asked();
    released.keep_edges = KeepEdges::Feature;
    Options sampled = asked();
    sampled.method = Method::Star;
    for (const Options& options : {graded, round, paper, released, sampled}) {
        Memory memory;
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

TEST(Memory, ForgetsWhatWasUsedLeastLately) {
    const auto part = [](double radius) { return geometry::make_cylinder(radius, 1.0); };
    Memory memory(2);
    const Result one = run(part(1.0), {}, memory);
    run(part(2.0), {}, memory);
    expect_same(run(part(1.0), {}, memory), one);
    run(part(3.0), {}, memory);  // two goes
    EXPECT_EQ(memory.runs(), 2U);
    EXPECT_GT(run(part(1.0), {}, memory).report.reused_faces, 0U);
    EXPECT_EQ(run(part(2.0), {}, memory).report.reused_faces, 0U);
}

TEST(Memory, KeepsToItsBytes) {
    const auto part = [](double radius) { return geometry::make_cylinder(radius, 1.0); };
    Memory all;
    run(part(1.0), {}, all);
    const std::size_t bytes = all.bytes();
    EXPECT_GT(bytes, 0U);
    Memory memory(8, bytes + bytes / 2);
    run(part(1.0), {}, memory);
    run(part(2.0), {}, memory);
    EXPECT_EQ(memory.runs(), 1U);
    EXPECT_LE(memory.bytes(), bytes + bytes / 2);
    Memory none(8, bytes / 2);
    run(part(1.0), {}, none);
    EXPECT_EQ(none.runs(), 0U);
}

}  // namespace
}  // namespace mq::triangulate
