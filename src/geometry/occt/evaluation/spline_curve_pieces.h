// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineCurve.hxx>
#include <cstddef>
#include <vector>

#include "base/vec.h"

namespace mq::geometry {

/// A point of a curve with its derivatives.
struct CurvePoint {
    Vec3 point = Vec3::Zero();
    Vec3 first = Vec3::Zero();
    Vec3 second = Vec3::Zero();
};

/// A range of a B-spline curve as polynomials, one for each of its spans: several times as fast as OpenCASCADE's
/// adaptor, which keeps one span.
class SplineCurvePieces {
  public:
    /// The range from `from` to `to` > `from`, in any turn of a periodic curve, but no more than a period.
    SplineCurvePieces(const Handle(Geom_BSplineCurve) & curve, double from, double to);

    /// The point and the first derivative at `t` in the range. On a knot the span after it is evaluated.
    CurvePoint first(double t);
    /// The point with first and second derivatives.
    CurvePoint second(double t);

  private:
    // x, y, z times the weight, and the weight; without weights the last entry is unused.
    using Homogeneous = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
    struct Arc {
        double middle = 0.0;
        double scale = 0.0;                     // 1 / half the length of the span
        std::vector<Homogeneous> coefficients;  // coefficients of powers of x from -1 to 1; none: not computed yet
    };

    const Arc& arc_at(double t);
    void build(std::size_t i);
    template <bool kSecond>
    CurvePoint evaluate(double t);

    Handle(Geom_BSplineCurve) curve_;
    bool rational_;
    std::vector<double> breaks_;  // the knots in the range, and its ends
    std::vector<Arc> arcs_;
    std::size_t last_ = 0;
};

}  // namespace mq::geometry
