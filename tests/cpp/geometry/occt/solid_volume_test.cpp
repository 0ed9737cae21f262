// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/solid_volume.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <vector>

#include "geometry/shapes.h"

namespace mq::geometry {
namespace {

double plain_content(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return std::abs(properties.Mass());
}

/// Three points for each wave: the interpolating surface has many spans, each of which the plain integration samples at
/// few points.
Handle(Geom_BSplineSurface) waves(double side, double height, int points) {
    TColStd_Array2OfReal z(1, points, 1, points);
    for (int i = 1; i <= points; ++i) {
        for (int k = 1; k <= points; ++k) {
            z(i, k) = height + std::sin(2.1 * i) * std::cos(2.1 * k);
        }
    }
    const double step = side / (points - 1);
    GeomAPI_PointsToBSplineSurface surface;
    surface.Interpolate(z, 0.0, step, 0.0, step);
    return surface.Surface();
}

TEST(ShapeContent, IsThatOfSimpleSolids) {
    EXPECT_NEAR(solid_content(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()).volume, 6.0, 1e-12);
    EXPECT_NEAR(solid_content(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape().Reversed()).volume, 6.0, 1e-12);
    EXPECT_NEAR(solid_content(BRepPrimAPI_MakeSphere(7.0).Shape()).volume, 4.0 / 3.0 * M_PI * 343.0, 1e-2);
    EXPECT_EQ(solid_content(BRepBuilderAPI_MakeFace(gp_Pln(), 0.0, 1.0, 0.0, 1.0).Shape()).volume, 0.0);
}

TEST(ShapeContent, IsThatOfATrimmedSplineFace) {
    // A disc of radius 9 under the waves, down to z = 0.
    const Handle(Geom_BSplineSurface) top = waves(20.0, 10.0, 60);
    const TopoDS_Shape above =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(top, 1e-6).Shape(), gp_Vec(0.0, 0.0, 20.0)).Shape();
    const TopoDS_Shape rod =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(10.0, 10.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), 9.0, 15.0).Shape();
    const TopoDS_Shape solid = BRepAlgoAPI_Cut(rod, above).Shape();
    // The integral over rings and angles, by the midpoint rule; the surface is a graph over x and y.
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    top->Bounds(u0, u1, v0, v1);
    double exact = 0.0;
    // Rings of the midpoint rule.
    constexpr int kRings = 450;
    // Angles of the midpoint rule.
    constexpr int kAngles = 900;
    for (int i = 0; i < kRings; ++i) {
        const double r = 9.0 * (i + 0.5) / kRings;
        for (int k = 0; k < kAngles; ++k) {
            const double a = 2.0 * M_PI * (k + 0.5) / kAngles;
            const double x = 10.0 + r * std::cos(a);
            const double y = 10.0 + r * std::sin(a);
            const gp_Pnt p = top->Value(u0 + (u1 - u0) * x / 20.0, v0 + (v1 - v0) * y / 20.0);
            ASSERT_NEAR(p.X(), x, 1e-9);
            ASSERT_NEAR(p.Y(), y, 1e-9);
            exact += p.Z() * r * (9.0 / kRings) * (2.0 * M_PI / kAngles);
        }
    }
    EXPECT_NEAR(solid_content(solid).volume / exact, 1.0, 1e-5);
    EXPECT_GT(std::abs(plain_content(solid) / exact - 1.0), 1e-4);
}

TEST(ShapeContent, CountsASolidOnceHoweverOftenItIsListed) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
    BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    builder.Add(all, box);
    builder.Add(all, box.Reversed());
    builder.Add(all, TopExp_Explorer(box, TopAbs_SHELL).Current());
    EXPECT_NEAR(solid_content(all).volume, 6.0, 1e-12);
}

}  // namespace
}  // namespace mq::geometry
