// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/checks/checked_use.h"

#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

namespace mq::geometry {

namespace {

const BRep_TEdge& definition(const TopoDS_Edge& edge) {
    return static_cast<const BRep_TEdge&>(*edge.TShape());
}

/// Whether a range lies within a curve, or within one of its turns.
template <typename Curve>
bool holds_range(const Curve& curve, double first, double last) {
    const double slack = Precision::PConfusion();
    return curve.IsPeriodic() ? last - first <= curve.Period() + slack
                              : first >= curve.FirstParameter() - slack && last <= curve.LastParameter() + slack;
}

Handle(Geom_Curve) untrimmed(const Handle(Geom_Curve) & curve) {
    const Handle(Geom_TrimmedCurve) trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve);
    return trimmed.IsNull() ? curve : trimmed->BasisCurve();
}

Handle(Geom2d_Curve) untrimmed(const Handle(Geom2d_Curve) & curve) {
    const Handle(Geom2d_TrimmedCurve) trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve);
    return trimmed.IsNull() ? curve : trimmed->BasisCurve();
}

}  // namespace

CheckedSurface::CheckedSurface(const TopoDS_Face& shape) : face(shape), surface(BRep_Tool::Surface(shape, place)) {
    transformation = place.Transformation();
    if (!surface.IsNull()) {
        adaptor.Load(surface);
    }
}

bool CheckedSurface::is_one_place(const gp_Pnt2d& a, const gp_Pnt2d& b, double tolerance) const {
    // As in BRepCheck_Wire.cxx: two points closer than this fraction of the surface's range count as one.
    constexpr double kShare = 0.01;
    const double du = std::abs(a.X() - b.X());
    const double dv = std::abs(a.Y() - b.Y());
    if (du < kShare * (adaptor.LastUParameter() - adaptor.FirstUParameter()) &&
        dv < kShare * (adaptor.LastVParameter() - adaptor.FirstVParameter())) {
        return true;
    }
    gp_Pnt point;
    gp_Vec su;
    gp_Vec sv;
    adaptor.D1(0.5 * (a.X() + b.X()), 0.5 * (a.Y() + b.Y()), point, su, sv);
    double most = std::max(adaptor.UResolution(tolerance), adaptor.VResolution(tolerance));
    for (const gp_Vec& along : {su, sv}) {
        if (along.Magnitude() > Precision::Confusion()) {
            most = std::max(most, tolerance / along.Magnitude());
        }
    }
    return std::max(du, dv) < 2.0 * most;
}

bool CheckedUse::read(const TopoDS_Edge& shape, const CheckedSurface& on) {
    edge = shape;
    return read_curves(on) && has_range() && read_ends(on) && (in_space_.IsNull() || lies_on(on));
}

/// Sets the curves, where there is one of each kind.
bool CheckedUse::read_curves(const CheckedSurface& on) {
    const BRep_TEdge& data = definition(edge);
    if (!data.SameParameter() || !data.SameRange()) {
        return false;
    }
    const TopLoc_Location on_edge = on.place.Predivided(edge.Location());
    int of_space = 0;
    int of_surface = 0;
    for (const Handle(BRep_CurveRepresentation) & each : data.Curves()) {
        if (each->IsCurve3D()) {
            ++of_space;
        } else if (each->IsCurveOnSurface(on.surface, on_edge)) {
            ++of_surface;
            twice = each->IsCurveOnClosedSurface();
            static_cast<const BRep_GCurve&>(*each).Range(first, last);
            curve = twice && edge.Orientation() == TopAbs_REVERSED ? each->PCurve2() : each->PCurve();
        }
    }
    double from = 0.0;
    double to = 0.0;
    in_space_ = BRep_Tool::Curve(edge, place_, from, to);
    const double slack = Precision::PConfusion();
    const bool one_each = of_space == 1 && of_surface == 1 && in_space_.IsNull() == data.Degenerated();
    const bool same_range = in_space_.IsNull() || (std::abs(from - first) <= slack && std::abs(to - last) <= slack);
    return one_each && same_range;
}

bool CheckedUse::has_range() const {
    return first < last && holds_range(*untrimmed(curve), first, last) &&
           (in_space_.IsNull() || holds_range(*untrimmed(in_space_), first, last));
}

/// Sets the ends, where there are two vertices whose tolerances hold them.
bool CheckedUse::read_ends(const CheckedSurface& on) {
    if (edge.NbChildren() != 2) {
        return false;
    }
    TopExp::Vertices(edge, vertices[0], vertices[1], Standard_True);
    for (std::size_t i = 0; i < 2; ++i) {
        if (vertices[i].IsNull() || !static_cast<const BRep_TVertex&>(*vertices[i].TShape()).Points().IsEmpty()) {
            return false;
        }
        const bool at_first = (i == 0) == (edge.Orientation() == TopAbs_FORWARD);
        const double t = at_first ? first : last;
        const gp_Pnt vertex = BRep_Tool::Pnt(vertices[i]);
        uv[i] = curve->Value(t);
        points[i] = on.at(uv[i]);
        distances[i] = points[i].Distance(vertex);
        if (!in_space_.IsNull()) {
            distances[i] =
                std::max(distances[i], in_space_->Value(t).Transformed(place_.Transformation()).Distance(vertex));
        }
        if (!(distances[i] <= BRep_Tool::Tolerance(vertices[i]))) {
            return false;
        }
    }
    return true;
}

/// Whether both curves are within the edge's tolerance of each other, at the points where OpenCASCADE looks.
bool CheckedUse::lies_on(const CheckedSurface& on) const {
    constexpr int kIntervals = 22;  // BRepLib_ValidateEdge::myControlPointsNumber
    const double most = BRep_Tool::Tolerance(edge) * BRep_Tool::Tolerance(edge);
    const GeomAdaptor_Curve in_space(in_space_, first, last);
    const Geom2dAdaptor_Curve on_surface(curve, first, last);
    const gp_Trsf place = place_.Transformation();
    const bool straight = in_space.GetType() == GeomAbs_Line && on_surface.GetType() == GeomAbs_Line &&
                          on.adaptor.GetType() == GeomAbs_Plane;
    const int intervals = straight ? 1 : kIntervals;  // the distance of points on two lines is largest at an end
    for (int i = 0; i <= intervals; ++i) {
        const double t = ((intervals - i) * first + i * last) / intervals;
        if (!(in_space.Value(t).Transformed(place).SquareDistance(on.at(on_surface.Value(t))) <= most)) {
            return false;
        }
    }
    return true;
}

}  // namespace mq::geometry
