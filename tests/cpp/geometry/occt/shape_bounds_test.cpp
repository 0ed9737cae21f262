// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "geometry/occt/evaluation/conversion.h"
#include "geometry/shapes.h"

namespace mq::geometry {
namespace {

const gp_Dir kAxis(1.0, 2.0, 3.0);

gp_Ax2 tilted() {
    return gp_Ax2(gp_Pnt(5.0, -3.0, 2.0), kAxis);
}

Vec3 axis() {
    return to_vec(kAxis);
}

/// The extent of a circle around the tilted axis along the coordinates, as a fraction of its radius.
Vec3 reach_of_circle() {
    return (Vec3::Ones() - axis().cwiseProduct(axis())).cwiseSqrt();
}

void expect_box(const TopoDS_Shape& shape, const Vec3& low, const Vec3& high) {
    const Box box = make_shape_model(shape)->topology().box;
    const double size = (high - low).maxCoeff();
    EXPECT_TRUE((box.low.array() <= low.array()).all()) << box.low.transpose() << " for " << low.transpose();
    EXPECT_TRUE((box.high.array() >= high.array()).all()) << box.high.transpose() << " for " << high.transpose();
    EXPECT_LT((box.low - low).norm() + (box.high - high).norm(), 1e-5 * size);
}

/// Checks the shape as the primitive, and as a B-spline.
void expect_both(const TopoDS_Shape& shape, const Vec3& low, const Vec3& high) {
    expect_box(shape, low, high);
    expect_box(BRepBuilderAPI_NurbsConvert(shape, Standard_True).Shape(), low, high);
}

TEST(ShapeBox, OfTiltedPrimitivesIsClose) {
    const Vec3 centre(5.0, -3.0, 2.0);
    const Vec3 circle = reach_of_circle();
    const Vec3 ring = 4.0 * circle + Vec3::Ones();
    expect_both(BRepPrimAPI_MakeTorus(tilted(), 4.0, 1.0).Shape(), centre - ring, centre + ring);
    expect_both(BRepPrimAPI_MakeSphere(tilted(), 3.0).Shape(), centre - Vec3::Constant(3.0),
                centre + Vec3::Constant(3.0));
    const Vec3 top = centre + 6.0 * axis();
    expect_both(BRepPrimAPI_MakeCylinder(tilted(), 2.0, 6.0).Shape(),
                (centre - 2.0 * circle).cwiseMin(top - 2.0 * circle),
                (centre + 2.0 * circle).cwiseMax(top + 2.0 * circle));
    expect_both(BRepPrimAPI_MakeCone(tilted(), 2.0, 0.0, 6.0).Shape(), (centre - 2.0 * circle).cwiseMin(top),
                (centre + 2.0 * circle).cwiseMax(top));
}

/// The shape is in a rotated and translated location, and mirrored.
TEST(ShapeBox, FollowsTheLocation) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(-1.0, 0.5, 2.0)), 1.1);
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(1.0, 0.0, 0.0), gp_Dir(1.0, 1.0, 0.3)));
    const TopoDS_Shape ball = BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeSphere(tilted(), 3.0).Shape(), true).Shape();
    for (const gp_Trsf& trsf : {turn, mirror}) {
        const Vec3 centre = to_vec(tilted().Location().Transformed(trsf));
        expect_box(ball.Located(TopLoc_Location(trsf), Standard_False), centre - Vec3::Constant(3.0),
                   centre + Vec3::Constant(3.0));
    }
}

/// The region that was cut off a ball does not count: along the cut's normal the shape ends at the plane, and across it
/// the edge is farthest where the plane passes the centre's far side.
TEST(ShapeBox, LeavesOutEdgesOfNoFace) {
    BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape());
    builder.Add(both, BRepBuilderAPI_MakeEdge(gp_Pnt(-50.0, 0.0, 0.0), gp_Pnt(90.0, 0.0, 0.0)).Edge());
    expect_box(both, Vec3::Zero(), Vec3(1.0, 2.0, 3.0));
}

TEST(ShapeBox, CountsOnlyWhatIsInsideTheFace) {
    const gp_Pln plane(gp_Pnt(0.0, 0.0, 1.0), gp::DZ());
    const TopoDS_Shape above =
        BRepPrimAPI_MakeHalfSpace(BRepBuilderAPI_MakeFace(plane).Face(), gp_Pnt(0.0, 0.0, 9.0)).Solid();
    const TopoDS_Shape below =
        BRepPrimAPI_MakeHalfSpace(BRepBuilderAPI_MakeFace(plane).Face(), gp_Pnt(0.0, 0.0, -9.0)).Solid();
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(), kAxis), 2.0).Shape();
    const double edge = std::sqrt(3.0);
    expect_both(BRepAlgoAPI_Cut(ball, above).Shape(), Vec3(-2.0, -2.0, -2.0), Vec3(2.0, 2.0, 1.0));
    expect_both(BRepAlgoAPI_Cut(ball, below).Shape(), Vec3(-edge, -edge, 1.0), Vec3(edge, edge, 2.0));
}

/// An arc that is revolved about an axis beside it: a barrel, widest between its edges.
TEST(ShapeBox, OfTurnedCurvesIsClose) {
    const Handle(Geom_TrimmedCurve) arc =
        GC_MakeArcOfCircle(gp_Pnt(1.0, 0.0, -1.0), gp_Pnt(1.5, 0.0, 0.2), gp_Pnt(1.0, 0.0, 1.0)).Value();
    const TopoDS_Shape barrel = BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(arc).Edge(), gp::OZ()).Shape();
    const gp_Circ circle = Handle(Geom_Circle)::DownCast(arc->BasisCurve())->Circ();
    const double widest = circle.Location().X() + circle.Radius();
    expect_box(barrel, Vec3(-widest, -widest, -1.0), Vec3(widest, widest, 1.0));
}

}  // namespace
}  // namespace mq::geometry
