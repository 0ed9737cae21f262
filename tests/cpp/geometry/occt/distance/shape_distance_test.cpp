// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/distance/shape_distance.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <ElCLib.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>
#include <iterator>
#include <utility>

#include "base/error.h"
#include "geometry/occt/brep_text.h"

namespace mq::geometry {
namespace {

double largest(const TopoDS_Shape& shape, const std::vector<Vec3>& points) {
    const std::vector<double> distances = distances_to_faces(shape, points);
    EXPECT_EQ(distances.size(), points.size());
    return *std::max_element(distances.begin(), distances.end());
}

TEST(ShapeDistance, CountsInsideASolidAndBeyondTrimmedBorders) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape();
    EXPECT_NEAR(largest(box, {Vec3(1, 1, 1)}), 1.0, 1e-12);
    EXPECT_NEAR(largest(box, {Vec3(1, 1, 2)}), 0.0, 1e-12);
    // Beside an edge and beside a corner: the planes extend beyond, the faces do not.
    EXPECT_NEAR(largest(box, {Vec3(3, 3, 1)}), std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(largest(box, {Vec3(3, 3, 3), Vec3(1, 1, 2)}), std::sqrt(3.0), 1e-12);
}

TEST(ShapeDistance, SphereWithItsPolesAndCentre) {
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(5.0).Shape();
    EXPECT_NEAR(largest(sphere, {Vec3(0, 0, 6)}), 1.0, 1e-9);
    EXPECT_NEAR(largest(sphere, {Vec3(0, 0, -4.5)}), 0.5, 1e-9);
    EXPECT_NEAR(largest(sphere, {Vec3(3, 0, 0)}), 2.0, 1e-9);
    EXPECT_NEAR(largest(sphere, {Vec3(0, 0, 0)}), 5.0, 1e-9);
}

TEST(ShapeDistance, APlateOfHundredsOfMetresWithAHole) {
    BRepBuilderAPI_MakePolygon hole;
    for (const auto& [x, y] :
         {std::pair(14995.33, -51647.77), std::pair(26166.34, -91764.40), std::pair(177350.73, 67088.86),
          std::pair(121861.70, 60639.43), std::pair(-11941.90, 45087.58)}) {
        hole.Add(gp_Pnt(x, y, 0.0));
    }
    hole.Close();
    const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(), 254569.502968)).Edge();
    TopoDS_Face plate = TopoDS::Face(BRepBuilderAPI_MakeFace(gp_Pln()).Face().EmptyCopied());
    BRep_Builder builder;
    builder.UpdateFace(plate, 3.64);
    builder.Add(plate, hole.Wire().Reversed());
    builder.Add(plate, BRepBuilderAPI_MakeWire(circle).Wire());
    EXPECT_NEAR(largest(plate, {Vec3(208987.0, 77074.0, 0.0)}), 0.0, 1e-6);
    EXPECT_GT(largest(plate, {Vec3(100000.0, 20000.0, 0.0)}), 1000.0) << "in the hole";
}

// The shapes are splines, whose nearest points are found by a search.
TEST(ShapeDistance, PartsOfAThousandthOfAMillimetreAreMeasuredAsLargeOnes) {
    // Radius of the sphere, mm.
    constexpr double kRadius = 3e-4;
    const TopoDS_Shape sphere = BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeSphere(kRadius).Shape()).Shape();
    std::vector<Vec3> points;
    for (int i = 0; i < 200; ++i) {
        const double turn = 2.4 * i;
        const double z = (i + 0.5) / 100.0 - 1.0;
        const double r = std::sqrt(1.0 - z * z);
        points.push_back(0.99 * kRadius * Vec3(r * std::cos(turn), r * std::sin(turn), z));
    }
    EXPECT_NEAR(largest(sphere, points), 0.01 * kRadius, 1e-9 * kRadius);
}

/// The surface is an extruded ellipse, whose nearest points are found by a search, too.
TEST(ShapeDistance, PartsOfAKilometreAreMeasuredAsSmallOnes) {
    for (const double size : {1.0, 1e3, 1e6}) {
        const gp_Elips ellipse(gp_Ax2(gp_Pnt(0.122 * size, 0.061 * size, -0.081 * size), gp_Dir(0.0, 0.0, 1.0)),
                               0.0603 * size, 0.0342 * size);
        const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(ellipse).Edge();
        const gp_Vec along = -0.4337 * size * gp_Vec(0.395, -0.31, -0.865);
        const TopoDS_Shape tube = BRepPrimAPI_MakePrism(edge, along).Shape();
        std::vector<Vec3> points;
        for (int i = 0; i < 2000; ++i) {
            gp_Pnt p = ElCLib::Value(2.4 * i, ellipse).Translated((i + 0.5) / 2000.0 * along);
            p.BaryCenter(0.99, ellipse.Location().Translated((i + 0.5) / 2000.0 * along), 0.01);
            points.emplace_back(p.X(), p.Y(), p.Z());
        }
        EXPECT_LT(largest(tube, points), 0.01 * 0.0604 * size) << size;
    }
}

/// A torus as a spline that is periodic in both directions, from inside and outside of its tube and from its axis.
TEST(ShapeDistance, PeriodicSplines) {
    constexpr double kMajor = 5.0;
    constexpr double kMinor = 2.0;
    const TopoDS_Shape torus = BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(kMajor, kMinor).Shape()).Shape();
    std::vector<Vec3> points{Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(kMajor, 0, 0), Vec3(0, -kMajor, 0)};
    for (int i = 0; i < 500; ++i) {
        points.emplace_back(9.0 * std::sin(1.0 * i), 9.0 * std::sin(1.7 * i), 3.0 * std::sin(2.3 * i));
    }
    const std::vector<double> distances = distances_to_faces(torus, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points[i];
        const double exact = std::abs(std::hypot(std::hypot(p.x(), p.y()) - kMajor, p.z()) - kMinor);
        EXPECT_NEAR(distances[i], exact, 1e-9) << i;
    }
}

/// One span that ends where it begins: its ends tell nothing of its size.
TEST(ShapeDistance, ClosedSpans) {
    TColgp_Array1OfPnt poles(1, 5);
    const gp_Pnt corners[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}, {0, 0, 0}};
    std::copy(std::begin(corners), std::end(corners), poles.begin());
    const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(poles);
    const TopoDS_Shape tube =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeEdge(curve).Edge(), gp_Vec(0.0, 0.0, 3.0)).Shape();
    for (const Vec3& p : {Vec3(1.7, 1.7, 1.5), Vec3(5, 2, 2), Vec3(1, 2, 1)}) {
        double sampled = 1e300;
        for (int i = 0; i <= 1000; ++i) {
            const gp_Pnt q = curve->Value(0.001 * i);
            const double above = std::clamp(p.z(), q.Z(), q.Z() + 3.0) - p.z();
            sampled = std::min(sampled, Vec3(q.X() - p.x(), q.Y() - p.y(), above).norm());
        }
        const double found = distances_to_faces(tube, {p}).front();
        EXPECT_LE(found, sampled + 1e-12);
        EXPECT_GT(found, sampled - 1e-4);
    }
}

/// A search through all samples of the surface for each point takes minutes here.
TEST(ShapeDistance, ManySpansAndPointsInSeconds) {
    constexpr int kPoles = 150;
    TColgp_Array2OfPnt poles(1, kPoles, 1, kPoles);
    const auto height = [](double x, double y) { return 3.0 * std::sin(0.4 * x) * std::cos(0.3 * y); };
    for (int i = 1; i <= kPoles; ++i) {
        for (int k = 1; k <= kPoles; ++k) {
            poles(i, k) = gp_Pnt(i, k, height(i, k));
        }
    }
    TColStd_Array1OfReal knots(1, kPoles - 2);
    TColStd_Array1OfInteger multiplicities(1, kPoles - 2);
    multiplicities.Init(1);
    multiplicities(1) = multiplicities(kPoles - 2) = 4;
    for (int i = 1; i <= kPoles - 2; ++i) {
        knots(i) = i;
    }
    const Handle(Geom_BSplineSurface) surface =
        new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
    const TopoDS_Shape land = BRepBuilderAPI_MakeFace(surface, 1e-6).Shape();
    std::vector<Vec3> points;
    std::vector<double> offsets;
    for (int i = 0; i < 5000; ++i) {
        const double u = 5.0 + 136.0 * std::fmod(0.6180339887 * i, 1.0);
        const double v = 5.0 + 136.0 * std::fmod(0.7548776662 * i, 1.0);
        gp_Pnt p;
        gp_Vec su;
        gp_Vec sv;
        surface->D1(u, v, p, su, sv);
        offsets.push_back(0.3 * std::sin(1.0 * i));  // below every radius of curvature
        p.Translate(offsets.back() * su.Crossed(sv).Normalized());
        points.emplace_back(p.X(), p.Y(), p.Z());
    }
    const auto start = std::chrono::steady_clock::now();
    const std::vector<double> distances = distances_to_faces(land, points);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 10.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(distances[i], std::abs(offsets[i]), 1e-9) << i;
    }
}

TEST(ShapeDistance, StopsWhenCancelledAndRefusesAShapeWithoutFaces) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape();
    Progress progress;
    progress.cancel();
    EXPECT_THROW(distances_to_faces(box, {Vec3(1, 1, 1)}, &progress), Cancelled);
    EXPECT_THROW(distances_to_faces(TopoDS_Shape(), {Vec3(1, 1, 1)}), InvalidInput);
}

TEST(BrepText, JunkIsRefused) {
    EXPECT_THROW(read_brep_text("no shape at all"), InvalidInput);
    EXPECT_THROW(read_brep_text(""), InvalidInput);
}

}  // namespace
}  // namespace mq::geometry
