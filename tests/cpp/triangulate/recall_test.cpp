// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/recall.h"

#include <BRepAlgoAPI_Cut.hxx>

#include "triangulate/checks.h"
#include "triangulate/memory.h"

/// Meshing a part again after an edit.
namespace mq::triangulate {
namespace {

constexpr int kAlong = 10;
constexpr int kAcross = 10;
constexpr double kPitch = 10.0;

/// A plate with a hundred holes, every other one blind: 156 faces. The first hole has another radius.
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
