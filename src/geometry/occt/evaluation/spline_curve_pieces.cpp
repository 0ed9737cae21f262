// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/spline_curve_pieces.h"

#include <BSplCLib.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <algorithm>
#include <cmath>

namespace mq::geometry {

SplineCurvePieces::SplineCurvePieces(const Handle(Geom_BSplineCurve) & curve, double from, double to)
    : curve_(curve), rational_(curve->IsRational()) {
    const double slack = 1e-14 * std::max(std::abs(from), std::abs(to));
    const double period = curve->IsPeriodic() ? curve->Period() : 0.0;
    const double turns = period > 0.0 ? std::floor((from - curve->FirstParameter()) / period) : 0.0;
    breaks_.push_back(from);
    for (const double turn : {turns * period, (turns + 1.0) * period}) {
        for (int i = curve->FirstUKnotIndex(); i <= curve->LastUKnotIndex(); ++i) {
            const double knot = curve->Knot(i) + turn;
            if (knot > breaks_.back() + slack && knot < to - slack) {
                breaks_.push_back(knot);
            }
        }
    }
    breaks_.push_back(to);
    arcs_.resize(breaks_.size() - 1);
}

void SplineCurvePieces::build(std::size_t i) {
    Arc& arc = arcs_[i];
    const double half = 0.5 * (breaks_[i + 1] - breaks_[i]);
    arc.middle = breaks_[i] + half;
    arc.scale = 1.0 / half;
    double within = arc.middle;
    if (curve_->IsPeriodic()) {
        within -= curve_->Period() * std::floor((within - curve_->FirstParameter()) / curve_->Period());
    }
    const TColStd_Array1OfReal& knots = curve_->KnotSequence();
    const auto next = std::upper_bound(knots.begin(), knots.end(), within) - knots.begin();
    const TColStd_Array1OfReal* weights = curve_->Weights();
    TColStd_Array2OfReal cache(1, curve_->Degree() + 1, 1, weights != nullptr ? 4 : 3);
    BSplCLib::BuildCache(within, half, curve_->IsPeriodic(), curve_->Degree(),
                         knots.Lower() + static_cast<int>(next) - 1, knots, curve_->Poles(), weights, cache);
    for (int k = 1; k <= curve_->Degree() + 1; ++k) {
        arc.coefficients.emplace_back(cache(k, 1), cache(k, 2), cache(k, 3), weights != nullptr ? cache(k, 4) : 1.0);
    }
}

const SplineCurvePieces::Arc& SplineCurvePieces::arc_at(double t) {
    if (!(t >= breaks_[last_] && t < breaks_[last_ + 1])) {
        const auto next = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, t);
        last_ = static_cast<std::size_t>(next - breaks_.begin()) - 1;
    }
    if (arcs_[last_].coefficients.empty()) {
        build(last_);
    }
    return arcs_[last_];
}

// Horner's scheme, for the derivatives too.
template <bool kSecond>
CurvePoint SplineCurvePieces::evaluate(double t) {
    const Arc& arc = arc_at(t);
    const double x = (t - arc.middle) * arc.scale;
    Homogeneous p = Homogeneous::Zero();
    Homogeneous d = Homogeneous::Zero();
    Homogeneous dd = Homogeneous::Zero();
    for (auto c = arc.coefficients.rbegin(); c != arc.coefficients.rend(); ++c) {
        if (kSecond) {
            dd = dd * x + d;
        }
        d = d * x + p;
        p = p * x + *c;
    }
    d *= arc.scale;
    CurvePoint r;
    r.point = p.head<3>();
    r.first = d.head<3>();
    if (kSecond) {
        dd *= 2.0 * arc.scale * arc.scale;
        r.second = dd.head<3>();
    }
    if (rational_) {
        // C = P / w: the derivatives of P = C w by the product rule, solved for those of C.
        const double w = 1.0 / p[3];
        r.point *= w;
        r.first = (r.first - r.point * d[3]) * w;
        if (kSecond) {
            r.second = (r.second - r.first * (2.0 * d[3]) - r.point * dd[3]) * w;
        }
    }
    return r;
}

CurvePoint SplineCurvePieces::first(double t) {
    return evaluate<false>(t);
}

CurvePoint SplineCurvePieces::second(double t) {
    return evaluate<true>(t);
}

}  // namespace mq::geometry
