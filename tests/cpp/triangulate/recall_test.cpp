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

struct Meshed {
    Result result;
    Memory memory;
};

Meshed run(const std::shared_ptr<geometry::Model>& model, const Options& options, const Memory* before = nullptr) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    Meshed made;
    made.result = triangulate(engine, model, options, nullptr, before, &made.memory);
    return made;
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

TEST(Recall, ThePartAsItWasKeepsItsMesh) {
    const Meshed first = run(plate(2.0), asked());
    const Meshed again = run(plate(2.0), asked(), &first.memory);
    const std::size_t faces = plate(2.0)->topology().faces.size();
    EXPECT_EQ(first.memory.faces.size(), faces);
    EXPECT_EQ(first.result.report.reused_faces, 0U);
    EXPECT_EQ(again.result.report.reused_faces, faces);
    EXPECT_EQ(again.result.mesh.triangles.size(), first.result.mesh.triangles.size());
    EXPECT_EQ(again.result.report.max_chord_height, first.result.report.max_chord_height);
    EXPECT_LT(again.result.report.queries, first.result.report.queries / 2);
    expect_guarantees(again.result, asked());
}

TEST(Recall, AnEditOfOneHoleLeavesTheOthers) {
    const Meshed first = run(plate(2.0), asked());
    const auto edited = plate(2.5);
    const Meshed again = run(edited, asked(), &first.memory);
    expect_guarantees(again.result, asked());
    // The wall of the hole, and the two faces that it goes through.
    EXPECT_GE(again.result.report.reused_faces + 8, edited->topology().faces.size());
    const Meshed once_more = run(edited, asked(), &first.memory);
    EXPECT_EQ(again.result.mesh.vertices, once_more.result.mesh.vertices);
    EXPECT_EQ(again.result.mesh.triangles, once_more.result.mesh.triangles);
}

TEST(Recall, OtherDemandsStartFromNothing) {
    const auto part = plate(2.0);
    const Meshed first = run(part, asked());
    Options coarser = asked();
    coarser.chord_height = 0.05;
    const Meshed again = run(part, coarser, &first.memory);
    EXPECT_EQ(again.result.report.reused_faces, 0U);
    EXPECT_EQ(again.result.mesh.vertices, mesh_of(part, coarser).mesh.vertices);
}

TEST(Recall, EditsBackAndForthKeepTheGuarantees) {
    Meshed last = run(plate(2.0), asked());
    for (const double radius : {2.5, 3.0, 2.0}) {
        last = run(plate(radius), asked(), &last.memory);
        expect_guarantees(last.result, asked());
    }
}

}  // namespace
}  // namespace mq::triangulate
