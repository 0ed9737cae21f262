// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "curve/checks.h"
#include "curve/placed_surface.h"
#include "curve/surface/repair.h"
#include "geometry/occt/shape_model.h"

namespace mq::curve {
namespace {

/// Vertices that deviate from their edges by a large fraction of a mesh edge, within their tolerance, as Booleans may
/// leave them.

const gp_Pnt kCorner(1.0, 0.0, 2.0);

/// A quarter of a cylinder of radius 1; its vertex at kCorner, and its tolerance, moved along the circle to this angle.
/// The curves stay as they are.
std::shared_ptr<geometry::Model> quarter_with_a_vertex_at(double angle) {
    const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(1.0, 2.0, 0.5 * M_PI).Shape();
    for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next()) {
        const TopoDS_Vertex vertex = TopoDS::Vertex(it.Current());
        if (BRep_Tool::Pnt(vertex).Distance(kCorner) < 1e-9) {
            const gp_Pnt moved(std::cos(angle), std::sin(angle), kCorner.Z());
            BRep_Builder().UpdateVertex(vertex, moved, 1.01 * moved.Distance(kCorner));
            break;
        }
    }
    return geometry::make_shape_model(shape);
}

double from_the_corner(const Vec3& p) {
    return (p - Vec3(kCorner.X(), kCorner.Y(), kCorner.Z())).norm();
}

TEST(Gaps, ElementsReachAVertexThatLiesOffItsEdges) {
    const auto model = quarter_with_a_vertex_at(0.2);
    for (int order = 2; order <= 5; ++order) {
        PlacedCurvedSurface placed(model, order, 0.3);
        EXPECT_GT(placed.invalid(), 0) << order;
        const Progress progress;
        const SurfaceRepairs repairs = repair_surface(placed.editor, progress);
        EXPECT_EQ(repairs.reached, 1) << order;
        EXPECT_EQ(repairs.invalid_after, 0) << order;
        for (const int t : live_triangles(placed.surface)) {
            EXPECT_GT(placed.editor.triangle(t).quality, 0.2) << order;
        }
    }
}

TEST(Gaps, OnlyElementsThereLeaveTheCad) {
    const CurvedMesh mesh = curved(quarter_with_a_vertex_at(0.2), of_order(3), 0.3);
    EXPECT_EQ(mesh.report.invalid, 0u) << to_text(mesh.report);
    ASSERT_EQ(mesh.report.notes.size(), 1u);
    EXPECT_NE(mesh.report.notes[0].text().find(" deviates 0.2 mm from "), std::string::npos)
        << mesh.report.notes[0].text();
    EXPECT_LT(mesh.report.max_deviation, 0.2);
    std::size_t far = 0;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec3& p = mesh.nodes[i];
        const bool on_side = std::min(p.x(), p.y()) > 1e-9 && p.z() > 1e-9 && p.z() < 2.0 - 1e-9;
        if (on_side && from_the_corner(p) > 1.0) {
            EXPECT_NEAR(p.head<2>().norm(), 1.0, 1e-9);
            ++far;
        }
    }
    EXPECT_GT(far, 100u);
}

TEST(Gaps, WhatIsSmallAgainstTheMeshKeepsTheNodesOnTheCad) {
    const CurvedMesh mesh = curved(quarter_with_a_vertex_at(0.002), of_order(3), 0.3);
    EXPECT_EQ(mesh.report.invalid, 0u);
    EXPECT_TRUE(mesh.report.notes.empty());
    std::size_t near = 0;
    for (std::size_t i = mesh.vertices; i < mesh.nodes.size(); ++i) {
        const Vec3& p = mesh.nodes[i];
        if (mesh.node_entity[i][0] == 1 && p.z() > 1.9 && from_the_corner(p) < 0.3 && p.y() > 1e-9) {
            EXPECT_NEAR(p.head<2>().norm(), 1.0, 1e-9);
            ++near;
        }
    }
    EXPECT_GE(near, 2u);
}

TEST(Gaps, VolumesBehindThemAreValid) {
    for (int order = 2; order <= 4; ++order) {
        const CurvedMesh mesh = curved(quarter_with_a_vertex_at(0.2), of_order(order, true), 0.3);
        EXPECT_EQ(mesh.report.invalid, 0u) << order << "\n" << to_text(mesh.report);
        EXPECT_EQ(invalid_tetrahedra(mesh), 0u) << order;
        expect_conforming(mesh);
    }
}

}  // namespace
}  // namespace mq::curve
