// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/incremental/face_fingerprints.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <set>

#include "geometry/parts.h"

/// Fingerprints of faces, which identify them from edit to edit.
namespace mq::triangulate {
namespace {

using namespace geometry;  // the shapes of its tests

std::vector<geometry::Fingerprint> keys(const std::shared_ptr<geometry::Model>& model) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    geometry::Session session(engine, model);
    return face_fingerprints(session);
}

std::vector<geometry::Fingerprint> keys(const TopoDS_Shape& shape) {
    return keys(make_shape_model(shape));
}

geometry::Fingerprint structure(const TopoDS_Shape& shape) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    geometry::Session session(engine, make_shape_model(shape));
    geometry::Fingerprint key{};
    add_structure(session, key);
    return key;
}

TopoDS_Shape block(double height) {
    return BRepPrimAPI_MakeBox(1.0, 2.0, height).Shape();
}

int common(const std::vector<geometry::Fingerprint>& a, const std::vector<geometry::Fingerprint>& b) {
    const std::set<geometry::Fingerprint> known(a.begin(), a.end());
    return static_cast<int>(
        std::count_if(b.begin(), b.end(), [&](const geometry::Fingerprint& k) { return known.count(k); }));
}

TopoDS_Shape moved(const TopoDS_Shape& shape) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1.0, 2.0, 3.0), gp_Dir(1.0, 1.0, 0.3)), 0.7);
    return shape.Moved(TopLoc_Location(turn));
}

/// A flat spline surface of 30 x 30 poles, except for the height of one pole.
TopoDS_Shape sheet(double height) {
    constexpr int kPoles = 30;  // Poles along each parameter.
    constexpr int kDegree = 3;  // Degree of the spline.
    TColgp_Array2OfPnt poles(1, kPoles, 1, kPoles);
    for (int i = 1; i <= kPoles; ++i) {
        for (int j = 1; j <= kPoles; ++j) {
            poles(i, j) = gp_Pnt(i, j, i == 19 && j == 19 ? height : 0.0);
        }
    }
    constexpr int kSpans = kPoles - kDegree;  // Knot spans of the spline.
    TColStd_Array1OfReal knots(1, kSpans + 1);
    TColStd_Array1OfInteger multiplicities(1, kSpans + 1);
    for (int i = 1; i <= kSpans + 1; ++i) {
        knots(i) = i - 1;
        multiplicities(i) = i == 1 || i == kSpans + 1 ? kDegree + 1 : 1;
    }
    const Handle(Geom_BSplineSurface) surface =
        new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, kDegree, kDegree);
    return BRepBuilderAPI_MakeFace(surface, 1e-7).Shape();
}

TEST(FaceKeys, AreThoseOfTheSameGeometry) {
    EXPECT_EQ(keys(block(3.0)), keys(block(3.0)));
    EXPECT_EQ(common(keys(block(3.0)), keys(block(3.5))), 1);  // only the bottom is equal
    EXPECT_EQ(keys(geometry::make_torus(3.0, 1.0)), keys(geometry::make_torus(3.0, 1.0)));
    EXPECT_EQ(common(keys(geometry::make_cone(2.0, 3.0)), keys(geometry::make_cone(2.5, 3.0))), 0);
}

TEST(FaceKeys, AreAllDifferentInOnePart) {
    for (const TopoDS_Shape& shape : {block(3.0), BRepPrimAPI_MakeCone(2.0, 1.0, 3.0).Shape()}) {
        const std::vector<geometry::Fingerprint> all = keys(shape);
        EXPECT_EQ(std::set<geometry::Fingerprint>(all.begin(), all.end()).size(), all.size());
    }
}

TEST(FaceKeys, DoNotDependOnNumbersOrThePlaceOfThePart) {
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeSphere(gp_Pnt(9.0, 9.0, 9.0), 1.0).Shape());
    builder.Add(both, block(3.0));
    EXPECT_EQ(common(keys(block(3.0)), keys(both)), 6);
    EXPECT_EQ(keys(block(3.0)), keys(moved(block(3.0))));
    EXPECT_NE(structure(block(3.0)), structure(moved(block(3.0))));
    EXPECT_EQ(structure(moved(block(3.0))), structure(moved(block(3.0))));
}

TEST(FaceKeys, DoNotDependOnRoundingInThePlaceOfThePart) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1.0, 2.0, 3.0), gp_Dir(1.0, 1.0, 0.3)), 0.7);
    gp_Trsf off;                          // as modellers set matrices: the scale is computed from them
    constexpr double kOff = 1.0 + 3e-16;  // A scale that differs from 1 by rounding.
    off.SetValues(kOff * turn.Value(1, 1), turn.Value(1, 2), turn.Value(1, 3), 5.0, turn.Value(2, 1), turn.Value(2, 2),
                  turn.Value(2, 3), 6.0, turn.Value(3, 1), turn.Value(3, 2), kOff * turn.Value(3, 3), 7.0);
    ASSERT_NE(off.ScaleFactor(), 1.0);
    EXPECT_EQ(keys(block(3.0)), keys(block(3.0).Moved(TopLoc_Location(off))));
}

TEST(FaceKeys, DependOnThePlaceOfAPieceInThePart) {
    TopoDS_Compound one;
    BRep_Builder builder;
    builder.MakeCompound(one);
    builder.Add(one, moved(block(3.0)));
    EXPECT_EQ(common(keys(block(3.0)), keys(one)), 0);
}

TEST(FaceKeys, SeeWhatLiesBetweenAnySamples) {
    EXPECT_EQ(keys(sheet(0.0)), keys(sheet(0.0)));
    EXPECT_NE(keys(sheet(0.0)), keys(sheet(1e-12)));
}

TEST(FaceKeys, SeeTolerances) {
    const TopoDS_Shape shape = block(3.0);
    const std::vector<geometry::Fingerprint> before = keys(shape);
    BRep_Builder().UpdateEdge(TopoDS::Edge(TopExp_Explorer(shape, TopAbs_EDGE).Current()), 1e-3);
    EXPECT_EQ(common(before, keys(shape)), 4);  // all except the two faces of that edge
}

TEST(FaceKeys, OfSplinesAndMirroredParts) {
    const auto nurbs = [](double height) { return BRepBuilderAPI_NurbsConvert(block(height)).Shape(); };
    EXPECT_EQ(keys(nurbs(3.0)), keys(nurbs(3.0)));
    EXPECT_EQ(common(keys(nurbs(3.0)), keys(block(3.0))), 0);
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(), gp_Dir(1.0, 0.0, 0.0)));
    const TopoDS_Shape mirrored = block(3.0).Moved(TopLoc_Location(mirror), false);
    EXPECT_EQ(keys(mirrored), keys(mirrored));
    EXPECT_EQ(common(keys(mirrored), keys(block(3.0))), 0);
    EXPECT_EQ(make_shape_model(mirrored)->place(), geometry::RigidMotion());
}

TEST(RigidMotion, TakesOnePlaceToAnother) {
    const geometry::RigidMotion a = make_shape_model(moved(block(3.0)))->place();
    const geometry::RigidMotion b = make_shape_model(moved(moved(block(3.0))))->place();
    const Vec3 own(0.3, 0.4, 0.5);
    EXPECT_LT((geometry::RigidMotion::between(a, b).of_point(a.of_point(own)) - b.of_point(own)).norm(), 1e-14);
    EXPECT_EQ(geometry::RigidMotion::between(a, a), geometry::RigidMotion());
    EXPECT_NE(a, b);
}

}  // namespace
}  // namespace mq::triangulate
