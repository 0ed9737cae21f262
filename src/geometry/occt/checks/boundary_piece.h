// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <vector>

#include "base/vec.h"

namespace mq::geometry {

/// A piece of a boundary in (u, v) that turns little: a line, an arc of a circle or an ellipse, or a polynomial. Its
/// points lie in the hull of its control points, and its directions in the cone of their differences.
class BoundaryPiece {
  public:
    /// The pieces of a curve from `first` to `last`, or back; none for other kinds of curves, for periodic splines, and
    /// where a curve has no direction, or turns much however often it is halved.
    static std::vector<BoundaryPiece> of(const Handle(Geom2d_Curve) & curve, double first, double last, bool forward);

    const Vec2& start() const { return controls_.front(); }
    const Vec2& end() const { return controls_.back(); }
    /// Unit vectors along the piece, at its start and its end.
    const Vec2& start_direction() const { return start_direction_; }
    const Vec2& end_direction() const { return end_direction_; }
    const Vec2& low() const { return low_; }
    const Vec2& high() const { return high_; }
    /// The largest distance of its points from its chord at most; none lies beyond the chord's ends.
    double height() const;

    /// Whether no point of the piece lies behind an earlier one, seen in this direction.
    bool ascends(const Vec2& direction) const;
    /// Whether a proof says that two pieces are farther apart than this.
    bool is_apart_from(const BoundaryPiece& other, double margin) const;

  private:
    using Controls = std::vector<Vec2>;

    static std::vector<Controls> of_conic(const Geom2d_Curve& conic, double first, double last);
    static std::vector<Controls> of_spline(const Geom2d_BSplineCurve& spline, double first, double last);
    bool set(Controls controls);

    Controls controls_;
    Vec2 start_direction_;
    Vec2 end_direction_;
    Vec2 low_;
    Vec2 high_;
};

}  // namespace mq::geometry
