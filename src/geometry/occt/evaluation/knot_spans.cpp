// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/knot_spans.h"

#include <BRepAdaptor_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>

namespace mq::geometry {

namespace {

// Degree assumed for curves and surfaces that are not polynomials themselves.
constexpr int kUsualDegree = 3;

// The spans of a curve, which `Intervals` writes into an array.
template <typename Intervals>
std::vector<double> bounds_of(int count, Intervals intervals) {
    TColStd_Array1OfReal bounds(1, count + 1);
    intervals(bounds);
    return {bounds.begin(), bounds.end()};
}

bool is_spline(GeomAbs_CurveType type) {
    return type == GeomAbs_BezierCurve || type == GeomAbs_BSplineCurve;
}

bool is_spline(GeomAbs_SurfaceType type) {
    return type == GeomAbs_BezierSurface || type == GeomAbs_BSplineSurface;
}

bool is_elementary(GeomAbs_SurfaceType type) {
    return type == GeomAbs_Plane || type == GeomAbs_Cylinder || type == GeomAbs_Cone || type == GeomAbs_Sphere ||
           type == GeomAbs_Torus;
}

}  // namespace

KnotSpans spans_of(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    if (!is_spline(curve.GetType()) && curve.GetType() != GeomAbs_OffsetCurve &&
        curve.GetType() != GeomAbs_OtherCurve) {
        return {};
    }
    const auto intervals = [&](TColStd_Array1OfReal& bounds) { curve.Intervals(bounds, GeomAbs_CN); };
    return {bounds_of(curve.NbIntervals(GeomAbs_CN), intervals),
            is_spline(curve.GetType()) ? curve.Degree() : kUsualDegree};
}

std::array<KnotSpans, 2> spans_of(const GeomAdaptor_Surface& surface) {
    if (is_elementary(surface.GetType())) {
        return {};
    }
    const bool spline = is_spline(surface.GetType());
    const auto in_u = [&](TColStd_Array1OfReal& bounds) { surface.UIntervals(bounds, GeomAbs_CN); };
    const auto in_v = [&](TColStd_Array1OfReal& bounds) { surface.VIntervals(bounds, GeomAbs_CN); };
    return {KnotSpans{bounds_of(surface.NbUIntervals(GeomAbs_CN), in_u), spline ? surface.UDegree() : kUsualDegree},
            KnotSpans{bounds_of(surface.NbVIntervals(GeomAbs_CN), in_v), spline ? surface.VDegree() : kUsualDegree}};
}

}  // namespace mq::geometry
