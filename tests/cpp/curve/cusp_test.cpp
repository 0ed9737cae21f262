// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include "curve/checks.h"
#include "curve/placed_surface.h"
#include "curve/surface/repair.h"
#include "geometry/occt/shape_model.h"

namespace mq::curve {
namespace {

/// A cylinder that stands on a box and touches one of its sides: the box's upper face has two cusps there.
std::shared_ptr<geometry::Model> boss_at_the_border() {
    const gp_Ax2 axis(gp_Pnt(2.0, 1.0, 0.5), gp::DZ());
    return geometry::make_shape_model(
        BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(4.0, 3.0, 1.0).Shape(), BRepPrimAPI_MakeCylinder(axis, 1.0, 1.5).Shape())
            .Shape());
}

TEST(Cusps, OpenWithoutLeavingTheCad) {
    for (int order = 2; order <= 5; ++order) {
        PlacedCurvedSurface placed(boss_at_the_border(), order, 0.8);
        const double plain = placed.editor.plain_deviation();
        const Progress progress;
        const SurfaceRepairs repairs = repair_surface(placed.editor, progress);
        EXPECT_GE(repairs.cusps, 2) << order;
        EXPECT_EQ(repairs.invalid_after, 0) << order;
        // Opening costs about 0.005 h^2 / R of the edges at the cusp, whatever the order.
        const double allowed = order <= 3 ? 1.01 * plain : 1e-6;
        EXPECT_LE(placed.editor.rms_deviation(live_triangles(placed.surface)), allowed) << order;
    }
}

TEST(Cusps, VolumesAtCuspsAreValid) {
    for (int order = 2; order <= 4; ++order) {
        const CurvedMesh mesh = curved(boss_at_the_border(), of_order(order, true), 0.8);
        EXPECT_EQ(mesh.report.invalid, 0u) << order << "\n" << to_text(mesh.report);
        EXPECT_EQ(invalid_tetrahedra(mesh), 0u) << order;
        EXPECT_GT(mesh.report.min_distortion, 0.1) << order;
        expect_conforming(mesh);
    }
}

}  // namespace
}  // namespace mq::curve
