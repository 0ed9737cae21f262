// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/elementary_surface.h"

namespace mq::geometry {

/// A B-spline surface as polynomials, one for each of its spans, kept for many of them. OpenCASCADE's adaptor keeps one
/// span, makes it anew whenever a question falls into another, and needs several times as long for derivatives.
class SplinePatches {
  public:
    explicit SplinePatches(const Handle(Geom_BSplineSurface) & surface);

    /// What lies between these bounds is inside of the knots' range by more than rounding: on its border the adaptor
    /// knows better.
    ParameterBox inside() const;
    /// The point and the first derivatives at (u, v), which must be inside. On a knot those of the span after it.
    SurfacePoint first(double u, double v);
    /// The second derivatives too.
    SurfacePoint second(double u, double v);

  private:
    // x, y, z times the weight, and the weight; without weights the last is not used.
    using Homogeneous = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
    struct Patch {
        double low[2] = {1.0, 1.0};  // of u and v; the patch holds below `high`
        double high[2] = {0.0, 0.0};
        double middle[2];
        double scale[2];                        // 1 / half the length
        std::vector<Homogeneous> coefficients;  // of x^i y^k, x and y from -1 to 1; k runs fastest

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
    std::vector<double> knots_[2];  // each once
    std::vector<Patch> slots_;
    std::size_t last_ = 0;  // slot
};

}  // namespace mq::geometry
