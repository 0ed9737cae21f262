// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/intersection_refinement.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Solid.hxx>
#include <map>
#include <utility>

#include "mesh/intersection/self_intersection.h"
#include "triangulate/checks.h"

/// Faces of one volume do not cross, however small their distance, unless the shape's own faces do.
namespace mq::triangulate {
namespace {

/// One solid with two spheres as its shells, the second one turned inside out.
TopoDS_Shape two_spheres(double radius, double other, double apart) {
    BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, BRepPrimAPI_MakeSphere(radius).Shell());
    builder.Add(solid, BRepPrimAPI_MakeSphere(gp_Pnt(apart, 0.0, 0.0), other).Shell().Reversed());
    return solid;
}

std::size_t self_intersections(const mesh::TriangleMesh& mesh) {
    return mesh::self_intersections(mesh.vertices, mesh.triangles).size();
}

/// Where the shape touches itself the mesh has one vertex for each side: here they are joined.
mesh::TriangleMesh welded(mesh::TriangleMesh mesh) {
    std::map<std::array<double, 3>, int> first;
    for (mesh::Triangle& t : mesh.triangles) {
        for (auto& v : t) {
            const Vec3& p = mesh.vertices[v];
            v = first.emplace(std::array<double, 3>{p.x(), p.y(), p.z()}, v).first->second;
        }
    }
    return mesh;
}

TEST(Crossings, ThinWallsAreRefinedUntilTheirSidesAreApart) {
    for (const double wall : {0.3, 0.1, 0.05, 0.02}) {
        SCOPED_TRACE(wall);
        const Result result = mesh_of(geometry::make_shape_model(two_spheres(10.0, 10.0 - wall, 0.0)));
        EXPECT_TRUE(result.report.closed);
        EXPECT_TRUE(result.report.manifold);
        expect_angles(result, 25.0);
        EXPECT_EQ(result.report.self_intersections, 0);
        EXPECT_EQ(self_intersections(result.mesh), 0u);
        // n triangles of height h over a sphere: about 4 pi r^2 / (0.43 * 8 r h), on both sides.
        EXPECT_LT(static_cast<double>(result.mesh.triangles.size()), 6.0 * 2.0 * 4.0 * M_PI * 10.0 / (3.4 * wall));
    }
}

/// Without the separation, 128 to 516 pairs of triangles crossed, and 12 to 116 after local improvement for better
/// angles.
TEST(Crossings, GoBeforeMinEdge) {
    for (const auto& [wall, min_edge] :
         {std::pair(0.1, 4.0), {0.1, 3.0}, {0.1, 1.0}, {0.05, 4.0}, {0.05, 2.0}, {0.03, 1.5}, {0.02, 3.0}}) {
        SCOPED_TRACE(wall);
        const TopoDS_Shape tube = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(10.0, 10.0).Shape(),
                                                  BRepPrimAPI_MakeCylinder(10.0 - wall, 10.0).Shape());
        TriangulateOptions options;
        options.min_edge = min_edge;
        const Result result = mesh_of(geometry::make_shape_model(tube), options);
        EXPECT_TRUE(result.report.closed);
        EXPECT_TRUE(result.report.manifold);
        EXPECT_EQ(result.report.self_intersections, 0);
        EXPECT_EQ(self_intersections(result.mesh), 0u);
        EXPECT_LT(static_cast<double>(result.mesh.triangles.size()), 200.0 / wall);
    }
}

TEST(Crossings, OfThePartItselfAreNamedAndEndTheWork) {
    const Result result = mesh_of(geometry::make_shape_model(two_spheres(10.0, 8.0, 5.0)));
    expect_angles(result, 25.0);
    EXPECT_TRUE(result.report.complete);
    EXPECT_EQ(static_cast<std::size_t>(result.report.self_intersections), self_intersections(result.mesh));
    EXPECT_GT(result.report.self_intersections, 0);
    ASSERT_FALSE(result.report.notes.empty());
    EXPECT_NE(result.report.notes.back().text().find("Face1 and Face2 cross in"), std::string::npos);
    EXPECT_LT(result.mesh.triangles.size(), 40000u);
}

/// A hollow whose tip ends in the middle of a face: the kernel inserts a vertex into that face.
TEST(Crossings, WhatTouchesAFaceInAPointSharesAVertexWithIt) {
    const gp_Ax2 below(gp_Pnt(5.0, 4.0, 2.0), gp::DZ());
    const TopoDS_Shape part = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape(),
                                              BRepPrimAPI_MakeCone(below, 3.0, 0.0, 8.0).Shape())
                                  .Shape();
    const auto model = geometry::make_shape_model(part);
    int inside = 0;
    for (const geometry::Face& face : model->topology().faces) {
        inside += static_cast<int>(face.points.size());
    }
    ASSERT_EQ(inside, 1);
    for (const double chord : {0.0, 0.05}) {
        TriangulateOptions options;
        options.chord_height = chord;
        const Result result = mesh_of(model, options);
        EXPECT_TRUE(result.report.closed);
        expect_angles(result, 25.0);
        EXPECT_EQ(result.report.self_intersections, 0);
        EXPECT_EQ(self_intersections(welded(result.mesh)), 0u);
    }
}

}  // namespace
}  // namespace mq::triangulate
