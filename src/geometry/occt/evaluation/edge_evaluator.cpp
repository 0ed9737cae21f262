// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/edge_evaluator.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/closed_edge.h"
#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {

namespace {

/// Relative accuracy of arc lengths.
constexpr double kLengthAccuracy = 1e-9;

}  // namespace

EdgeEvaluator::EdgeEvaluator(const TopoDS_Edge& shape, const Edge& data, Evaluation evaluation)
    : native_(evaluation == Evaluation::Native), data_(data), t0_(data.t0), t1_(data.t1) {
    slack_ = 1e-9 * std::max({std::abs(t0_), std::abs(t1_), t1_ - t0_});
    TopLoc_Location location;
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(shape, location, first, last);
    if (curve.IsNull()) {
        curve_ = new BRepAdaptor_Curve(shape);
    } else {
        curve_ = new GeomAdaptor_Curve(curve, t0_, t1_);
        location_ = location.Transformation();
        located_ = !location.IsIdentity();
        if (!native_ && curve_->GetType() == GeomAbs_BSplineCurve && t0_ < t1_) {
            arcs_.emplace(curve_->BSpline(), t0_, t1_);
        }
    }
    if (native_) {
        kind_ = Kind::Other;
    } else if (curve_->GetType() == GeomAbs_Line) {
        kind_ = Kind::Line;
    } else if (curve_->GetType() == GeomAbs_Circle) {
        kind_ = Kind::Circle;
    }
    if (kind_ == Kind::Other) {
        TColStd_Array1OfReal knots(1, curve_->NbIntervals(GeomAbs_C2) + 1);
        curve_->Intervals(knots, GeomAbs_C2);
        knots_.assign(knots.begin(), knots.end());
    }
    for (int i = 0; i < 8; ++i) {
        size_ += (at(t0_ + (i + 1) * (t1_ - t0_) / 8.0) - at(t0_ + i * (t1_ - t0_) / 8.0)).norm();
    }
}

bool EdgeEvaluator::in_range(double t) const {
    return t >= t0_ - slack_ && t <= t1_ + slack_;
}

/// The point in the curve's own coordinates.
Vec3 EdgeEvaluator::value(double t) const {
    return arcs_ ? arcs_->first(t).point : to_vec(curve_->Value(t));
}

CurvePoint EdgeEvaluator::first(double t) const {
    if (arcs_) {
        return arcs_->first(t);
    }
    gp_Pnt p;
    gp_Vec d;
    curve_->D1(t, p, d);
    return {to_vec(p), to_vec(d)};
}

CurvePoint EdgeEvaluator::second(double t) const {
    if (arcs_) {
        return arcs_->second(t);
    }
    gp_Pnt p;
    gp_Vec d[2];
    curve_->D2(t, p, d[0], d[1]);
    return {to_vec(p), to_vec(d[0]), to_vec(d[1])};
}

Vec3 EdgeEvaluator::at(double t) const {
    const Vec3 p = value(t);
    return located_ ? to_vec(to_pnt(p).Transformed(location_)) : p;
}

double EdgeEvaluator::speed(double t) const {
    const double own = first(t).first.norm();
    return located_ ? own * std::abs(location_.ScaleFactor()) : own;
}

Answer EdgeEvaluator::at_parameter(double t) const {
    const CurvePoint p = first(t);
    Answer answer;
    answer.status = Status::Ok;
    answer.t = t;
    answer.point = p.point;
    answer.normal = p.first;
    if (located_) {
        answer.point = to_vec(to_pnt(p.point).Transformed(location_));
        answer.normal = to_vec(gp_Vec(p.first.x(), p.first.y(), p.first.z()).Transformed(location_));
    }
    return answer;
}

Answer EdgeEvaluator::point(double t) const {
    Answer answer;
    answer.status = Status::BadQuery;
    if (over_end(t)) {
        answer = at_parameter(in_first_turn(data_, t));
        answer.t = t;
        return answer;
    }
    return in_range(t) ? at_parameter(std::clamp(t, t0_, t1_)) : answer;
}

double EdgeEvaluator::gauss(double from, double to) const {
    // Abscissae of the Gauss-Legendre quadrature with eight points.
    static constexpr std::array<double, 4> kX{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                              0.9602898564975363};
    // Weights of that quadrature.
    static constexpr std::array<double, 4> kW{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                              0.1012285362903763};
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    double sum = 0.0;
    for (std::size_t i = 0; i < kX.size(); ++i) {
        sum += kW[i] * (speed(middle - half * kX[i]) + speed(middle + half * kX[i]));
    }
    return sum * half;
}

double EdgeEvaluator::arc_within(double from, double to, double whole, int depth) const {
    const double middle = 0.5 * (from + to);
    const double left = gauss(from, middle);
    const double right = gauss(middle, to);
    const double accuracy = kLengthAccuracy * std::max(left + right, 0.01 * size_);
    if (depth == 0 || std::abs(left + right - whole) <= accuracy) {
        return left + right;
    }
    return arc_within(from, middle, left, depth - 1) + arc_within(middle, to, right, depth - 1);
}

double EdgeEvaluator::smooth_arc(double from, double to) const {
    // Halvings of an interval at most: then it is 4096 times shorter.
    constexpr int kDepth = 12;
    return from < to ? arc_within(from, to, gauss(from, to), kDepth) : 0.0;
}

/// Arc length from `from` to `to`, mm; negative when `to` comes first.
double EdgeEvaluator::arc(double from, double to) const {
    if (native_) {
        return native_arc(from, to);
    }
    if (kind_ != Kind::Other) {
        return speed(from) * (to - from);
    }
    if (to < from) {
        return -arc(to, from);
    }
    if (sums_.empty()) {
        sums_.push_back(0.0);
        for (std::size_t i = 1; i < knots_.size(); ++i) {
            sums_.push_back(sums_.back() + smooth_arc(knots_[i - 1], knots_[i]));
        }
    }
    const auto first = std::upper_bound(knots_.begin(), knots_.end(), from) - knots_.begin();
    const auto last = std::lower_bound(knots_.begin(), knots_.end(), to) - knots_.begin() - 1;
    if (last < first) {
        return smooth_arc(from, to);
    }
    const auto i = static_cast<std::size_t>(first);
    const auto k = static_cast<std::size_t>(last);
    return smooth_arc(from, knots_[i]) + (sums_[k] - sums_[i]) + smooth_arc(knots_[k], to);
}

Answer EdgeEvaluator::length(double from, double to) const {
    Answer answer;
    if (over_end(from) || over_end(to)) {
        answer.status = Status::Ok;
        answer.distance = std::abs(arc_over_end(from, to));
        return answer;
    }
    if (!in_range(from) || !in_range(to)) {
        answer.status = Status::BadQuery;
        return answer;
    }
    answer.status = Status::Ok;
    answer.distance = std::abs(arc(std::clamp(from, t0_, t1_), std::clamp(to, t0_, t1_)));
    return answer;
}

Answer EdgeEvaluator::middle(double from, double to) const {
    Answer answer;
    if (over_end(from) || over_end(to)) {
        return middle_over_end(from, to);
    }
    if (!in_range(from) || !in_range(to)) {
        answer.status = Status::BadQuery;
        return answer;
    }
    double low = std::clamp(from, t0_, t1_);
    double high = std::clamp(to, t0_, t1_);
    double t = 0.5 * (low + high);
    if (kind_ != Kind::Other) {
        return at_parameter(t);
    }
    if (native_) {
        return at_parameter(native_middle(low, high));
    }
    const double whole = arc(low, high);
    double rest = 0.5 * whole - arc(low, t);
    // Steps at most: bisection alone would reach double precision in that number.
    constexpr int kArcSteps = 60;
    for (int i = 0; i < kArcSteps && std::abs(rest) > kLengthAccuracy * std::abs(whole); ++i) {
        // The length grows from low to high; with high < low all signs change and the quotients stay.
        ((rest > 0.0) == (whole > 0.0) ? low : high) = t;
        const double slope = speed(t);
        double next = slope > 0.0 ? t + rest / slope : low;
        if (!(next > std::min(low, high) && next < std::max(low, high))) {
            next = 0.5 * (low + high);
        }
        rest -= arc(t, next);
        if (next == t) {
            break;
        }
        t = next;
    }
    return at_parameter(t);
}

/// The parameter at which the distance from `start` equals `distance`, between `low`, which is nearer, and `high`,
/// which is farther.
double EdgeEvaluator::crossing(const Vec3& start, double low, double high, double distance) const {
    double f_low = (at(low) - start).norm() - distance;
    double f_high = (at(high) - start).norm() - distance;
    // Steps at most; the bracket halves at least every other step.
    constexpr int kDistanceSteps = 100;
    int kept = 0;
    for (int i = 0; i < kDistanceSteps && std::abs(high - low) > 1e-15 * std::max(std::abs(low), std::abs(high)); ++i) {
        const double t = i % 8 == 7 ? 0.5 * (low + high) : (low * f_high - high * f_low) / (f_high - f_low);
        const double f = (at(t) - start).norm() - distance;
        if (std::abs(f) <= 1e-13 * distance) {
            return t;
        }
        // Illinois method: halve the value of an end that stays twice.
        if (f < 0.0) {
            low = t;
            f_low = f;
            f_high *= kept == 1 ? 0.5 : 1.0;
            kept = 1;
        } else {
            high = t;
            f_high = f;
            f_low *= kept == -1 ? 0.5 : 1.0;
            kept = -1;
        }
    }
    return high;
}

Answer EdgeEvaluator::at_distance(double from, double to, double distance) const {
    Answer answer;
    if (!in_range(from) || !in_range(to) || !(distance >= 0.0)) {
        answer.status = Status::BadQuery;
        return answer;
    }
    answer.status = Status::NotFound;
    const double start = std::clamp(from, t0_, t1_);
    const double end = std::clamp(to, t0_, t1_);
    const double sign = end < start ? -1.0 : 1.0;
    const double range = std::abs(end - start);
    if (kind_ != Kind::Other) {
        const double v = speed(start);
        double step = distance / v;
        if (kind_ == Kind::Circle) {
            step = distance <= 2.0 * v ? 2.0 * std::asin(0.5 * distance / v) : 2.0 * range + 1.0;
        }
        return step <= range + slack_ ? at_parameter(std::clamp(start + sign * step, t0_, t1_)) : answer;
    }
    const Vec3 origin = at(start);
    double t = start;
    double reached = 0.0;
    while (t != end) {
        // The straight distance grows no faster than the arc; the step is a little longer than the arc, so that the
        // crossing gets bracketed.
        const double v = speed(t);
        const double room = 1.01 * (distance - reached) + 1e-6 * distance;
        const double step = std::clamp(v > 0.0 ? room / v : range, 1e-4 * range, range / 16.0);
        const double next = sign * (end - (t + sign * step)) > 0.0 ? t + sign * step : end;
        reached = (at(next) - origin).norm();
        if (reached >= distance) {
            return at_parameter(crossing(origin, t, next, distance));
        }
        t = next;
    }
    return answer;
}

}  // namespace mq::geometry
