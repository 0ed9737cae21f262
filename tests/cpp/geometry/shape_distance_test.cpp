// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/shape_distance.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>

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
    // Beside an edge and beside a corner: the planes run on, the faces do not.
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

// As splines, whose nearest points are searched for.
TEST(ShapeDistance, PartsOfAThousandthOfAMillimetreAreMeasuredAsLargeOnes) {
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
