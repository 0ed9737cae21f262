// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/curve_shape.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <cmath>

#include "base/error.h"
#include "workflows/operands/triangulate_shape.h"

namespace mq::workflows {
namespace {

class Curving : public testing::Test {
  protected:
    geometry::Engine engine{geometry::Engine::Mode::Direct};
    Progress progress;
    triangulate::TriangulateOptions straight;
    curve::CurveOptions options;
};

TEST_F(Curving, AShapeGetsValidElementsAndTheVolumeOfItsSolid) {
    const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape();
    straight.chord_height = 0.05;
    options.order = 3;
    options.volume = true;
    const curve::CurvedMesh mesh = curve_shape(engine, shape, options, straight, progress);
    EXPECT_EQ(mesh.report.invalid, 0u);
    EXPECT_GT(mesh.report.elements, 0u);
    EXPECT_NEAR(mesh.report.cad_volume, 2.0 * M_PI, 1e-9);
    EXPECT_LT(std::abs(mesh.report.volume_error()), 1e-3);
    EXPECT_EQ(mesh.report.chord_height_asked, 0.05);
    EXPECT_EQ(mesh.report.straight.triangles, mesh.straight.triangles.size());
    EXPECT_GT(mesh.report.cpu_seconds, 0.0);
}

TEST_F(Curving, ASurfaceIsCurvedOnceWithItsOwnTriangles) {
    const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape();
    straight.chord_height = 0.1;
    const triangulate::Result surface = triangulate_shape(engine, shape, straight, progress);
    const curve::CurvedMesh mesh = curve_surface(engine, shape, surface, options, progress);
    EXPECT_EQ(mesh.straight.triangles, surface.mesh.triangles);
    EXPECT_EQ(mesh.report.chord_height_asked, 0.1);
    EXPECT_NEAR(mesh.report.cad_volume, 2.0 * M_PI, 1e-9);
}

TEST_F(Curving, WrongOptionsAreNamed) {
    const TopoDS_Shape shape = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
    options.order = 9;
    EXPECT_THROW(curve_shape(engine, shape, options, straight, progress), InvalidInput);
    options.order = 2;
    straight.min_angle = 80.0;
    EXPECT_THROW(curve_shape(engine, shape, options, straight, progress), InvalidInput);
}

}  // namespace
}  // namespace mq::workflows
