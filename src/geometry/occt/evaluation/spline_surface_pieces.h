// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/elementary/surface.h"

namespace mq::geometry {

/// A B-spline surface as polynomials, one for each of its spans, kept for many of them. OpenCASCADE's adaptor keeps one
/// span, computes it anew whenever a query is in another, and needs several times as long for derivatives.
class SplineSurfacePieces {
  public:
    explicit SplineSurfacePieces(const Handle(Geom_BSplineSurface) & surface);

    /// The bounds inside of the knots' range by more than rounding: on its border the adaptor is used.
    ParameterBox inside() const;
    /// The point alone: the same as that of the other two, to the last bit.
    Vec3 point(double u, double v);
    /// The point and the first derivatives at (u, v), which must be inside. On a knot the span after it is evaluated.
    SurfacePoint first(double u, double v);
    /// The point with first and second derivatives.
    SurfacePoint second(double u, double v);

  private:
    // x, y, z times the weight, and the weight; without weights the last entry is unused.
    using Homogeneous = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
    struct Patch {
        double low[2] = {1.0, 1.0};  // lower bounds of u and v; the polynomial holds below `high`
        double high[2] = {0.0, 0.0};
        double middle[2];
        double scale[2];                        // 1 / half the length of the span
        std::vector<Homogeneous> coefficients;  // coefficients of x^i y^k, x and y from -1 to 1; k runs fastest

        bool holds(double u, double v) const { return u >= low[0] && u < high[0] && v >= low[1] && v < high[1]; }
    };
    struct Sums;

    const Patch& at(double u, double v);
    void build(std::size_t i, std::size_t k, Patch& patch) const;
    template <bool kSecond>
    SurfacePoint evaluate(double u, double v);

    Handle(Geom_BSplineSurface) surface_;
    bool rational_;
    int degree_[2];
    std::vector<double> knots_[2];  // knots, each once
    std::vector<Patch> slots_;
    std::size_t last_ = 0;  // slot of the last query
};

}  // namespace mq::geometry
