// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Adaptor3d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Trsf.hxx>
#include <optional>
#include <vector>

#include "geometry/evaluation.h"
#include "geometry/occt/evaluation/spline_curve_pieces.h"
#include "geometry/query.h"
#include "geometry/topology.h"

namespace mq::geometry {

/// Answers for one edge. The curve is evaluated in its own coordinates; points are transformed by the edge's location.
class EdgeEvaluator {
  public:
    EdgeEvaluator(const TopoDS_Edge& shape, const Edge& data, Evaluation evaluation = Evaluation::Fast);

    Answer point(double t) const;
    Answer middle(double from, double to) const;
    Answer at_distance(double from, double to, double distance) const;
    Answer nearest(const Vec3& point, double guess, double low, double high) const;
    /// The nearest point of all in [low, high], found from many samples: a curve of several turns is near a point more
    /// than once.
    Answer nearest_of_all(const Vec3& point, double low, double high) const;
    Answer length(double from, double to) const;

  private:
    enum class Kind { Line, Circle, Other };

    bool in_range(double t) const;
    bool over_end(double t) const;
    double arc_over_end(double from, double to) const;
    Answer middle_over_end(double from, double to) const;
    Answer nearest_over_end(const Vec3& point, double guess, double low, double high) const;
    Vec3 value(double t) const;
    CurvePoint first(double t) const;
    CurvePoint second(double t) const;
    Vec3 at(double t) const;
    double speed(double t) const;
    Answer at_parameter(double t) const;
    double arc(double from, double to) const;
    double smooth_arc(double from, double to) const;
    double arc_within(double from, double to, double whole, int depth) const;
    double gauss(double from, double to) const;
    double crossing(const Vec3& start, double low, double high, double distance) const;
    bool newton(const Vec3& point, double low, double high, double& t) const;
    double native_arc(double from, double to) const;
    double native_middle(double low, double high) const;
    std::optional<double> native_nearest(const Vec3& point, double guess, double low, double high) const;
    double nearest_sampled(const Vec3& point, double low, double high) const;
    double nearest_on_circle(const Vec3& point, double guess, double low, double high) const;

    Handle(Adaptor3d_Curve) curve_;
    bool native_;  ///< whether OpenCASCADE evaluates, projects and measures lengths
    mutable std::optional<SplineCurvePieces> arcs_;
    gp_Trsf location_;
    bool located_ = false;
    Kind kind_ = Kind::Other;
    Edge data_;
    double t0_;
    double t1_;
    double slack_;                      ///< tolerance of t beyond the range, for rounding
    double size_ = 0.0;                 ///< size of the curve, the unit of relative lengths
    std::vector<double> knots_;         ///< parameters where the curve is less than smooth, and the ends
    mutable std::vector<double> sums_;  ///< arc lengths up to the knots, computed at the first request
};

}  // namespace mq::geometry
