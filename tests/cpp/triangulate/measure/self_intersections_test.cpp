// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/self_intersections.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Pln.hxx>
#include <vector>

#include "geometry/assemblies.h"
#include "mesh/intersection/self_intersection.h"
#include "triangulate/checks.h"

/// Which pairs of triangles count as faults, as overlaps of different bodies, or not at all.

namespace mq::triangulate {
namespace {

std::size_t pairs_that_meet(const mesh::TriangleMesh& mesh) {
    return mesh::self_intersections(mesh.vertices, mesh.triangles).size();
}

/// The faces alone, none of which shares an edge with another.
TopoDS_Compound faces_apart(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Shape> faces;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
        faces.push_back(BRepBuilderAPI_Copy(it.Current()).Shape());
    }
    return geometry::compound_of(faces);
}

TEST(SelfIntersections, OfDifferentVolumesAreCountedAndNoFault) {
    TriangulateOptions options;
    options.chord_height = 0.1;
    const TopoDS_Shape one = BRepPrimAPI_MakeSphere(10.0).Solid();
    const TopoDS_Shape other = BRepPrimAPI_MakeSphere(gp_Pnt(5.0, 0.0, 0.0), 10.0).Solid();
    const Result alone = mesh_of(geometry::make_shape_model(one), options);
    const Result result = mesh_of(geometry::make_shape_model(geometry::compound_of({one, other})), options);
    EXPECT_EQ(result.report.self_intersections, 0);
    EXPECT_GT(result.report.overlaps, 10);
    EXPECT_LE(static_cast<std::size_t>(result.report.overlaps), pairs_that_meet(result.mesh));
    EXPECT_TRUE(result.report.crossings.empty());
    EXPECT_FALSE(mesh::has_faults(result.report));
    ASSERT_FALSE(result.report.notes.empty());
    EXPECT_EQ(result.report.notes.back().text().find("bodies overlap: "), 0u);
    EXPECT_LT(result.mesh.triangles.size(), 3 * alone.mesh.triangles.size());
}

/// Solids that fit tightly cross by their chords only, and faces that are coplanar within rounding do not cross at
/// all.
TEST(SelfIntersections, ATightFitIsNoOverlap) {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-10.0, -10.0, 0.0), gp_Pnt(10.0, 10.0, 10.0)).Shape();
    const gp_Ax2 axis(gp_Pnt(0.0, 0.0, -5.0), gp::DZ(), gp_Dir(1.0, 0.3, 0.0));
    const TopoDS_Shape shaft = BRepPrimAPI_MakeCylinder(axis, 4.0, 20.0).Shape();
    const TopoDS_Shape beside = BRepPrimAPI_MakeBox(gp_Pnt(10.0, -7.0, 0.0), gp_Pnt(20.0, 7.0, 12.0)).Shape();
    const Result result = mesh_of(
        geometry::make_shape_model(geometry::compound_of({BRepAlgoAPI_Cut(block, shaft).Shape(), shaft, beside})));
    EXPECT_GT(pairs_that_meet(result.mesh), 0u);
    EXPECT_EQ(result.report.self_intersections, 0);
    EXPECT_EQ(result.report.overlaps, 0);
}

/// Faces that no solid or shell joins were not examined before.
TEST(SelfIntersections, OfLooseFacesAreNamed) {
    const gp_Pln upright(gp_Pnt(3.0, 0.0, 0.0), gp::DX());
    const TopoDS_Shape plane = BRepBuilderAPI_MakeFace(gp_Pln(), -10.0, 10.0, -10.0, 10.0).Shape();
    const TopoDS_Shape other = BRepBuilderAPI_MakeFace(upright, -5.0, 5.0, -5.0, 5.0).Shape();
    const Result planes = mesh_of(geometry::make_shape_model(geometry::compound_of({plane, other})));
    EXPECT_LE(static_cast<std::size_t>(planes.report.self_intersections), pairs_that_meet(planes.mesh));
    EXPECT_GT(planes.report.self_intersections, 0);
    EXPECT_EQ(planes.report.overlaps, 0);
    EXPECT_TRUE(mesh::has_faults(planes.report));
    ASSERT_EQ(planes.report.crossings.size(), 1u);
    ASSERT_FALSE(planes.report.notes.empty());
    EXPECT_EQ(planes.report.notes.back().text().find("Face1 and Face2 cross in "), 0u);
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-1.0, -1.0, -1.0), gp_Pnt(1.0, 1.0, 1.0)).Shape();
    const Result with_body = mesh_of(geometry::make_shape_model(geometry::compound_of({plane, box})));
    EXPECT_EQ(with_body.report.self_intersections, 0);
    EXPECT_GT(with_body.report.overlaps, 0);
}

/// Loose faces meet in edges of which each has its own: they touch there, or cross by their chord errors.
TEST(SelfIntersections, LooseFacesSideBySideDoNotCross) {
    const gp_Ax2 axis(gp_Pnt(0.0, 0.0, 6.0), gp::DX());
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-8.0, -8.0, 0.0), gp_Pnt(8.0, 8.0, 12.0)).Shape();
    const TopoDS_Shape bored = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(axis, 3.0, 9.0).Shape()).Shape();
    for (const TopoDS_Shape& part : {bored, BRepPrimAPI_MakeCone(5.0, 2.0, 8.0).Shape()}) {
        const Result result = mesh_of(geometry::make_shape_model(faces_apart(part)));
        EXPECT_EQ(result.report.self_intersections, 0);
        EXPECT_EQ(result.report.overlaps, 0);
        EXPECT_FALSE(mesh::has_faults(result.report));
    }
}

}  // namespace
}  // namespace mq::triangulate
