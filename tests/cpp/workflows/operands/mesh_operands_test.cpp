// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/operands/mesh_operands.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "base/error.h"
#include "boolean/closed_solids.h"
#include "geometry/occt/distance/shape_distance.h"
#include "geometry/occt/sub_shapes.h"
#include "workflows/offset_shape.h"
#include "workflows/operands/distance_mesh.h"
#include "workflows/operands/triangulate_shape.h"
#include "workflows/wrap_objects.h"

namespace mq::workflows {
namespace {

class FromShapes : public testing::Test {
  protected:
    Operands of(const std::vector<TopoDS_Shape>& shapes) {
        Operands operands(engine);
        for (const TopoDS_Shape& shape : shapes) {
            operands.add({"operand " + std::string(1, static_cast<char>('A' + operands.given().size())), nullptr, false,
                          geometry::kept(shape)});
        }
        return operands;
    }
    Operands box() { return of({BRepPrimAPI_MakeBox(10.0, 20.0, 30.0).Shape()}); }

    geometry::Engine engine{geometry::Engine::Mode::Direct};
    Progress progress;
};

TEST_F(FromShapes, SizeAndThicknessAreThoseOfAllOperands) {
    Operands operands = box();
    EXPECT_NEAR(operands.size(), 30.0, 1e-6);
    EXPECT_NEAR(operands.divided_length(), 30.0, 1e-6);
    operands.add({"operand B", nullptr, false, geometry::kept(BRepPrimAPI_MakeCylinder(0.5, 40.0).Shape())});
    EXPECT_NEAR(operands.size(), 40.0, 1e-6);
    EXPECT_NEAR(operands.divided_length(), 8.0 * 2.0 * (M_PI * 0.25 * 40.0) / (M_PI * 40.0 + 2.0 * M_PI * 0.25), 1e-3);
    operands.add({"operand C", std::make_shared<triangulate::Result>(
                                   triangulate::Result{boolean::solids::box(Vec3(0, 0, 0), Vec3(60, 1, 1)), {}})});
    EXPECT_NEAR(operands.size(), 60.5, 1e-6);
}

TEST_F(FromShapes, SizeIsThatOfTheShapeAndNotOfItsPoles) {
    TColgp_Array1OfPnt poles(1, 3);
    poles.SetValue(1, gp_Pnt(0.0, 0.0, 0.0));
    poles.SetValue(2, gp_Pnt(10.0, 100.0, 0.0));
    poles.SetValue(3, gp_Pnt(20.0, 0.0, 0.0));
    const TopoDS_Shape arch =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)).Shape(), gp_Vec(0.0, 0.0, 5.0));
    EXPECT_NEAR(of({arch}).size(), 50.0, 0.01);
}

TEST_F(FromShapes, OffsetHasOneOperand) {
    EXPECT_THROW(offset_shape(Operands(engine), {1.0, 0.05, 0}, progress), InvalidInput);
    EXPECT_THROW(hollow_shape(Operands(engine), std::vector<std::int32_t>{5}, {1.0, 0.0, 0}, progress), InvalidInput);
}

TEST_F(FromShapes, BooleanOfShapesTellsHowFarTheirMeshesDeviate) {
    const Operands operands =
        of({BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape(), BRepPrimAPI_MakeCylinder(2.0, 20.0).Shape()});
    const BooleanSurface result = boolean_of_operands(
        operands, boolean::Expression::chain(boolean::Operation::Difference, 2), {}, BooleanMethod::Exact, progress);
    EXPECT_TRUE(met(result.figures));
    EXPECT_NEAR(result.figures.volume, 1000.0 - 10.0 * M_PI, 0.3);
    ASSERT_EQ(result.figures.notes.size(), 2u);
    EXPECT_EQ(result.figures.notes[0].text().rfind("operand A is a shape: its mesh deviates by at most", 0), 0u);
    EXPECT_EQ(result.figures.seconds[1].first, "meshing shapes");
    EXPECT_EQ(progress.fraction(), 1.0);
}

TEST_F(FromShapes, OffsetHasTheAskedTolerance) {
    const BooleanSurface result = offset_shape(box(), {1.0, 0.05, 0}, progress);
    const double edges = 4.0 * (10.0 + 20.0 + 30.0);
    EXPECT_NEAR(result.figures.volume, 6000.0 + 2200.0 + 0.25 * M_PI * edges + 4.0 / 3.0 * M_PI, 5.0);
    EXPECT_TRUE(met(result.figures));
    EXPECT_EQ(result.figures.tolerance_asked, 0.05);
    EXPECT_EQ(result.mesh.triangle_face.size(), result.mesh.triangles.size());
}

TEST_F(FromShapes, HollowIsClosedOrReachesItsOpening) {
    const double inside = 8.0 * 18.0 * 28.0;
    const BooleanSurface closed = hollow_shape(box(), std::nullopt, {1.0, 0.0, 0}, progress);
    EXPECT_NEAR(closed.figures.volume, 6000.0 - inside, 1.0);
    EXPECT_EQ(closed.figures.tolerance_asked, 1.0 / 40.0);
    EXPECT_EQ(closed.figures.components, 2u);
    ASSERT_EQ(closed.figures.notes.size(), 1u);
    EXPECT_EQ(closed.figures.notes[0].text().rfind("the hollow is closed", 0), 0u);
    const BooleanSurface open = hollow_shape(box(), std::vector<std::int32_t>{5}, {1.0, 0.0, 0}, progress);
    EXPECT_NEAR(open.figures.volume, 6000.0 - inside * 29.0 / 28.0, 1.0);
    EXPECT_EQ(open.figures.components, 1u);
    EXPECT_THROW(hollow_shape(box(), std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}, {1.0, 0.0, 0}, progress),
                 InvalidInput);
    EXPECT_THROW(hollow_shape(box(), std::nullopt, {1.0, 2.0, 0}, progress), InvalidInput);
}

TEST_F(FromShapes, WrapNumbersTheFacesOfAllObjects) {
    const Operands objects =
        of({BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape(), BRepPrimAPI_MakeCylinder(2.0, 20.0).Shape()});
    wrap::WrapOptions options;
    options.gap = 2.0;
    const WrapSurface result = wrap_objects(objects, options, progress);
    EXPECT_TRUE(met(result.figures));
    EXPECT_EQ(result.faces, (std::vector<std::int32_t>{6, 3}));
    EXPECT_EQ(*std::max_element(result.mesh.triangle_face.begin(), result.mesh.triangle_face.end()), 8);
    options.spacing = 1.5;
    EXPECT_THROW(wrap_objects(objects, options, progress), InvalidInput);
}

TEST_F(FromShapes, ToleranceBelowSinglePrecisionIsRefusedBeforeMeshing) {
    OperandMeshing meshing;
    meshing.tolerance = 1e-7;
    EXPECT_THROW(box().meshed(meshing, progress, 0.0, 1.0), InvalidInput);
    EXPECT_EQ(std::string(progress.name()), "start");
}

TEST_F(FromShapes, VolumeIsKeptUnlessThatTakesTooManyTriangles) {
    const Operands rod = of({BRepPrimAPI_MakeCylinder(5.0, 200.0).Shape()});
    OperandMeshing meshing;
    meshing.tolerance = 0.68;
    meshing.volume_error = 0.002;
    const MeshedOperands fine = rod.meshed(meshing, progress, 0.0, 1.0);
    EXPECT_NEAR(fine.surfaces.front()->report.volume / (M_PI * 5000.0), 1.0, 0.002);
    EXPECT_EQ(fine.work.notes.front().text().find("volume"), std::string::npos);
    meshing.most_triangles = 1000.0;
    const MeshedOperands coarse = rod.meshed(meshing, progress, 0.0, 1.0);
    EXPECT_NE(coarse.work.notes.front().text().find(", and its volume by about "), std::string::npos);
}

TEST_F(FromShapes, MeshByDistanceAloneHasFewTriangles) {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(4.0, 3.0).Shape();
    const DistanceMesh mesh = mesh_within(engine, cylinder, 0.01, 0, progress);
    triangulate::TriangulateOptions options;
    options.chord_height = 0.01;
    EXPECT_LE(mesh.deviation, 0.01);
    EXPECT_TRUE(mesh.notes.empty());
    EXPECT_TRUE(mesh.surface.report.closed);
    EXPECT_LT(2 * mesh.surface.mesh.triangles.size(),
              triangulate_shape(engine, cylinder, options, progress).mesh.triangles.size());
}

TEST_F(FromShapes, TriangulationOfTheKernelIsRefinedUntilItIsNearAndTheShapeKeepsItsOwn) {
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(5.0).Shape();
    const BRepMesh_IncrementalMesh shown(sphere, 1.0);
    const TopoDS_Face face = TopoDS::Face(TopExp_Explorer(sphere, TopAbs_FACE).Current());
    TopLoc_Location location;
    const int before = BRep_Tool::Triangulation(face, location)->NbTriangles();
    const auto [mesh, deviation] = kernel_mesh(engine, sphere, 0, 0.01, progress);
    EXPECT_GT(deviation, 0.0);
    EXPECT_LE(deviation, 0.01);
    std::vector<Vec3> middles;
    for (const mesh::Triangle& t : mesh.triangles) {
        Vec3 sum = Vec3::Zero();
        for (const std::int32_t corner : t) {
            sum += mesh.vertices[static_cast<std::size_t>(corner)];
        }
        middles.emplace_back(sum / 3.0);
    }
    for (const double distance : geometry::distances_to_faces(face, middles)) {
        EXPECT_LE(distance, deviation + 1e-7);
    }
    EXPECT_EQ(BRep_Tool::Triangulation(face, location)->NbTriangles(), before);
}

}  // namespace
}  // namespace mq::workflows
