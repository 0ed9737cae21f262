// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp.hxx>
#include <gp_Ax1.hxx>

/// Shapes with faces that have creases inside.
namespace mq::geometry {

/// Knots 0, 1, ... of a spline of degree 1.
inline void linear_knots(TColStd_Array1OfReal& knots, TColStd_Array1OfInteger& multiplicities) {
    const int count = knots.Length();
    for (int i = 1; i <= count; ++i) {
        knots(i) = i - 1.0;
        multiplicities(i) = i == 1 || i == count ? 2 : 1;
    }
}

/// A rectangle of 4 by 3 in the plane z = 0 that a single spline goes around, from the corner at the origin.
inline TopoDS_Face rectangle_with_one_edge() {
    TColgp_Array1OfPnt corners(1, 5);
    corners(1) = gp_Pnt(0.0, 0.0, 0.0);
    corners(2) = gp_Pnt(4.0, 0.0, 0.0);
    corners(3) = gp_Pnt(4.0, 3.0, 0.0);
    corners(4) = gp_Pnt(0.0, 3.0, 0.0);
    corners(5) = corners(1);
    TColStd_Array1OfReal knots(1, 5);
    TColStd_Array1OfInteger multiplicities(1, 5);
    linear_knots(knots, multiplicities);
    const TopoDS_Edge around = BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(corners, knots, multiplicities, 1)).Edge();
    return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(around).Wire(), true).Face();
}

/// A block of 4 by 3 by 2 whose four sides are one face over one spline: Face1 the sides, Edge1 its seam.
inline TopoDS_Shape block_with_one_side() {
    return BRepPrimAPI_MakePrism(rectangle_with_one_edge(), gp_Vec(0.0, 0.0, 2.0)).Shape();
}

/// A ring whose four sides are one face, closed in both directions.
inline TopoDS_Shape ring_with_one_side() {
    return BRepPrimAPI_MakeRevol(rectangle_with_one_edge(), gp_Ax1(gp_Pnt(-2.0, 0.0, 0.0), gp::DY())).Shape();
}

/// A wing with a blunt trailing edge as OpenVSP writes them, one face with one seam: u runs from the middle of the flat
/// root end to that of the tip end, v from the middle of the trailing edge around and back. Where an end meets the
/// trailing edge, u * v patches of the surface are lines; the borders in the middle of the ends run to and fro.
inline TopoDS_Shape wing_with_flat_ends() {
    TColgp_Array2OfPnt poles(1, 5, 1, 5);
    TColStd_Array1OfReal knots(1, 5);
    TColStd_Array1OfInteger multiplicities(1, 5);
    linear_knots(knots, multiplicities);
    for (int i = 1; i <= 5; ++i) {
        const bool middle = i == 1 || i == 5;
        const double chord = i < 3 ? 12.0 : i == 3 ? 9.0 : 6.0;
        const double span = i < 3 ? 0.0 : i == 3 ? 12.0 : 24.0;
        const double half = middle ? 0.0 : 0.1 * chord;
        poles(i, 1) = gp_Pnt(chord, span, 0.0);
        poles(i, 2) = gp_Pnt(chord, span, -half);
        poles(i, 3) = gp_Pnt(0.0, span, 0.0);
        poles(i, 4) = gp_Pnt(chord, span, half);
        poles(i, 5) = poles(i, 1);
    }
    return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 1, 1),
                                   1e-7)
        .Shape();
}

/// Another one, whose trailing edge is sharp in the middle of the span and widens to both ends: its patches are
/// triangles, with a side that is a point.
inline TopoDS_Shape wing_with_a_sharp_middle() {
    TColgp_Array2OfPnt poles(1, 5, 1, 7);
    TColStd_Array1OfReal u_knots(1, 5);
    TColStd_Array1OfReal v_knots(1, 7);
    TColStd_Array1OfInteger u_multiplicities(1, 5);
    TColStd_Array1OfInteger v_multiplicities(1, 7);
    linear_knots(u_knots, u_multiplicities);
    linear_knots(v_knots, v_multiplicities);
    for (int i = 1; i <= 5; ++i) {
        const bool middle = i == 1 || i == 5;
        const double chord = i < 3 ? 12.0 : i == 3 ? 9.0 : 6.0;
        const double span = i < 3 ? 0.0 : i == 3 ? 12.0 : 24.0;
        const double half = middle ? 0.0 : 0.1 * chord;
        const double edge = middle || i == 3 ? 0.0 : 0.02 * chord;
        poles(i, 1) = gp_Pnt(chord, span, 0.0);
        poles(i, 2) = gp_Pnt(chord, span, -edge);
        poles(i, 3) = gp_Pnt(0.4 * chord, span, -half);
        poles(i, 4) = gp_Pnt(0.0, span, 0.0);
        poles(i, 5) = gp_Pnt(0.4 * chord, span, half);
        poles(i, 6) = gp_Pnt(chord, span, edge);
        poles(i, 7) = poles(i, 1);
    }
    return BRepBuilderAPI_MakeFace(
               new Geom_BSplineSurface(poles, u_knots, v_knots, u_multiplicities, v_multiplicities, 1, 1), 1e-7)
        .Shape();
}

}  // namespace mq::geometry
