// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/self_intersections.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>

#include "curve/placed_surface.h"
#include "geometry/occt/shape_model.h"

namespace mq::curve {
namespace {

TEST(SurfaceCrossings, CoarseTrianglesOfThinWallsAreRefined) {
    // After a rotation the inner sphere gets triangles that are not parallel to those of the outer one.
    const gp_Ax2 turned(gp::Origin(), gp::DX());
    const TopoDS_Shape shell =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(1.0).Shape(), BRepPrimAPI_MakeSphere(turned, 0.97).Shape()).Shape();
    // Triangles of one shell are separated before they are curved, faces that no shell joins are not.
    TopoDS_Compound faces;
    BRep_Builder builder;
    builder.MakeCompound(faces);
    for (TopExp_Explorer face(shell, TopAbs_FACE); face.More(); face.Next()) {
        builder.Add(faces, face.Current());
    }
    const mesh::TriangleMesh crossing = PlacedCurvedSurface::straight(geometry::make_shape_model(faces), 0.9);
    PlacedCurvedSurface placed(geometry::make_shape_model(shell), 2, crossing);
    const Progress progress;
    ASSERT_FALSE(find_self_intersections(placed.surface, 0, progress).empty());
    EXPECT_NE(first_fault(placed.surface, placed.session.topology(), 0, progress).find("meet near"), std::string::npos);
    EXPECT_GT(refine_crossings(placed.editor, placed.session.topology(), progress), 0);
    EXPECT_TRUE(find_self_intersections(placed.surface, 0, progress).empty());
    EXPECT_EQ(placed.invalid(), 0);
    placed.expect_closed();
}

}  // namespace
}  // namespace mq::curve
