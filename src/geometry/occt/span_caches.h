// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BSplSLib_Cache.hxx>
#include <Geom_BSplineSurface.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <utility>
#include <vector>

namespace mq::geometry {

/// The polynomials of a B-spline surface, kept for many of its spans. OpenCASCADE's adaptor keeps those of one span,
/// and makes them anew whenever a question falls into another: as costly as several answers.
class SpanCaches {
  public:
    explicit SpanCaches(const Handle(Geom_BSplineSurface) & surface);

    /// Whether (u, v) is inside of the knots' range by more than rounding: on its border the adaptor knows better.
    bool contains(double u, double v) const;
    /// The polynomials that hold at (u, v), which must be contained. The reference is good until the next call.
    const BSplSLib_Cache& at(double u, double v);

  private:
    struct Slot {
        std::size_t span;
        Handle(BSplSLib_Cache) cache;
    };
    std::size_t span_of(double u, double v) const;

    Handle(Geom_BSplineSurface) surface_;
    std::vector<double> knots_[2];  // each once
    std::vector<Slot> slots_;
};

}  // namespace mq::geometry
