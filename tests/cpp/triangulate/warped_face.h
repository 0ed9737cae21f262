// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepBuilderAPI_MakeFace.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <cmath>
#include <functional>
#include <memory>

#include "geometry/occt/shape_model.h"

/// Faces on free-form surfaces for the tests of sampling.
namespace mq::triangulate {

/// A square of side 10 with the given heights over its 4 x 4 poles, in two parameterisations: with weights c^i d^j
/// instead of 1 the points do not change, but the parameters are c and d times as fast at one end as in the middle,
/// and c^2 and d^2 times as fast as at the other (u = t / (t + c (1 - t)), Farin 1997, section 13.6).
inline std::shared_ptr<geometry::Model> bezier_face(const std::function<double(int, int)>& height, double c, double d) {
    TColgp_Array2OfPnt poles(1, 4, 1, 4);
    TColStd_Array2OfReal weights(1, 4, 1, 4);
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            poles.SetValue(i + 1, j + 1, gp_Pnt(10.0 * i / 3.0, 10.0 * j / 3.0, height(i, j)));
            weights.SetValue(i + 1, j + 1, std::pow(c, i) * std::pow(d, j));
        }
    }
    const Handle(Geom_BezierSurface) surface = new Geom_BezierSurface(poles, weights);
    return geometry::make_shape_model(BRepBuilderAPI_MakeFace(surface, 1e-7).Face());
}

/// A gentle saddle.
inline std::shared_ptr<geometry::Model> warped_face(double c, double d) {
    return bezier_face([](int i, int j) { return (i == 1 || i == 2) != (j == 1 || j == 2) ? 4.0 : 0.0; }, c, d);
}

/// A surface that is flat except for a ridge near one side.
inline std::shared_ptr<geometry::Model> peaked_face() {
    TColgp_Array2OfPnt poles(1, 7, 1, 3);
    const double x[7] = {0.0, 4.0, 4.9, 5.0, 5.1, 6.0, 10.0};
    const double z[7] = {0.0, 0.0, 1.0, 8.0, 1.0, 0.0, 0.0};
    for (int i = 0; i < 7; ++i) {
        for (int j = 0; j < 3; ++j) {
            poles.SetValue(i + 1, j + 1, gp_Pnt(x[i], 5.0 * j, z[i]));
        }
    }
    const Handle(Geom_BezierSurface) surface = new Geom_BezierSurface(poles);
    return geometry::make_shape_model(BRepBuilderAPI_MakeFace(surface, 1e-7).Face());
}

/// A square of side 10 with `waves` / pi half waves along x, and seven tenths of that number along y, in an oblique
/// direction.
inline std::shared_ptr<geometry::Model> wavy_face(double waves, double height) {
    constexpr int kPoints = 21;  // Points along each parameter.
    TColgp_Array2OfPnt points(1, kPoints, 1, kPoints);
    for (int i = 0; i < kPoints; ++i) {
        for (int j = 0; j < kPoints; ++j) {
            const double x = i / (kPoints - 1.0);
            const double y = j / (kPoints - 1.0);
            const double z = height * std::sin(waves * x) * std::cos(0.7 * waves * y + x);
            points.SetValue(i + 1, j + 1, gp_Pnt(10.0 * x, 10.0 * y, z));
        }
    }
    GeomAPI_PointsToBSplineSurface surface;
    surface.Interpolate(points);
    return geometry::make_shape_model(BRepBuilderAPI_MakeFace(surface.Surface(), 1e-7).Face());
}

/// A steep flank of a thread: five turns close above each other with the same orientation.
inline std::shared_ptr<geometry::Model> thread_face() {
    constexpr int kAround = 101;  // Points along the thread, twenty for each turn and one at its end.
    TColgp_Array2OfPnt points(1, kAround, 1, 2);
    for (int i = 0; i < kAround; ++i) {
        const double angle = 10.0 * M_PI * i / (kAround - 1);
        for (int j = 0; j < 2; ++j) {
            const double radius = 2.4 + 0.6 * j;
            points.SetValue(
                i + 1, j + 1,
                gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 0.5 * (angle / (2.0 * M_PI) + 0.35 * j)));
        }
    }
    GeomAPI_PointsToBSplineSurface surface;
    surface.Interpolate(points);
    return geometry::make_shape_model(BRepBuilderAPI_MakeFace(surface.Surface(), 1e-7).Face());
}

}  // namespace mq::triangulate
