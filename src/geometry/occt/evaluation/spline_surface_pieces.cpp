// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/evaluation/spline_surface_pieces.h"

#include <BSplSLib.hxx>
#include <Precision.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <algorithm>

namespace mq::geometry {

namespace {

// Most KnotSpans that are kept: those of bicubic surfaces need 150 kB.
constexpr std::size_t kSlots = 256;

std::vector<double> values(const TColStd_Array1OfReal& array) {
    return {array.begin(), array.end()};
}

// The index of the span that begins at `knot`, among all knots with their multiplicities.
int flat_index(const TColStd_Array1OfReal& knots, double knot) {
    return knots.Lower() + static_cast<int>(std::upper_bound(knots.begin(), knots.end(), knot) - knots.begin()) - 1;
}

// The number of the interval, from 0, that contains `t`.
std::size_t interval(const std::vector<double>& knots, double t) {
    const auto next = std::upper_bound(knots.begin() + 1, knots.end() - 1, t);
    return static_cast<std::size_t>(next - knots.begin()) - 1;
}

}  // namespace

SplineSurfacePieces::SplineSurfacePieces(const Handle(Geom_BSplineSurface) & surface)
    : surface_(surface),
      rational_(surface->IsURational() || surface->IsVRational()),
      degree_{surface->UDegree(), surface->VDegree()},
      knots_{values(surface->UKnots()), values(surface->VKnots())} {
    slots_.resize(std::min(kSlots, (knots_[0].size() - 1) * (knots_[1].size() - 1)));
}

ParameterBox SplineSurfacePieces::inside() const {
    const double slack = Precision::PConfusion();
    return {{knots_[0].front() + slack, knots_[1].front() + slack},
            {knots_[0].back() - slack, knots_[1].back() - slack}};
}

const SplineSurfacePieces::Patch& SplineSurfacePieces::at(double u, double v) {
    if (slots_[last_].holds(u, v)) {
        return slots_[last_];
    }
    const std::size_t i = interval(knots_[0], u);
    const std::size_t k = interval(knots_[1], v);
    last_ = (i * (knots_[1].size() - 1) + k) % slots_.size();
    if (!slots_[last_].holds(u, v)) {
        build(i, k, slots_[last_]);
    }
    return slots_[last_];
}

void SplineSurfacePieces::build(std::size_t i, std::size_t k, Patch& patch) const {
    const std::size_t at[2] = {i, k};
    double half[2];
    for (int d = 0; d < 2; ++d) {
        patch.low[d] = knots_[d][at[d]];
        patch.high[d] = knots_[d][at[d] + 1];
        half[d] = 0.5 * (patch.high[d] - patch.low[d]);
        patch.middle[d] = patch.low[d] + half[d];
        patch.scale[d] = 1.0 / half[d];
    }
    // Rows are powers of the parameter of the higher degree, of v where both degrees are equal.
    const bool rows_of_u = degree_[0] > degree_[1];
    const int size = rational_ ? 4 : 3;
    TColStd_Array2OfReal cache(1, std::max(degree_[0], degree_[1]) + 1, 1,
                               size * (std::min(degree_[0], degree_[1]) + 1));
    const TColStd_Array1OfReal& u = surface_->UKnotSequence();
    const TColStd_Array1OfReal& v = surface_->VKnotSequence();
    BSplSLib::BuildCache(patch.middle[0], patch.middle[1], half[0], half[1], surface_->IsUPeriodic(),
                         surface_->IsVPeriodic(), degree_[0], degree_[1], flat_index(u, patch.low[0]),
                         flat_index(v, patch.low[1]), u, v, surface_->Poles(), surface_->Weights(), cache);
    patch.coefficients.clear();
    for (int a = 0; a <= degree_[0]; ++a) {
        for (int b = 0; b <= degree_[1]; ++b) {
            Homogeneous c = Homogeneous::Zero();
            for (int x = 0; x < size; ++x) {
                c[x] = rows_of_u ? cache(a + 1, size * b + x + 1) : cache(b + 1, size * a + x + 1);
            }
            patch.coefficients.push_back(c);
        }
    }
}

// Values of the polynomial and its derivatives in x and y; `xx` and `yy` are halves.
struct SplineSurfacePieces::Sums {
    Homogeneous p = Homogeneous::Zero();
    Homogeneous x = Homogeneous::Zero();
    Homogeneous y = Homogeneous::Zero();
    Homogeneous xx = Homogeneous::Zero();
    Homogeneous xy = Homogeneous::Zero();
    Homogeneous yy = Homogeneous::Zero();
};

// Horner's scheme, for the derivatives too.
template <bool kSecond>
SurfacePoint SplineSurfacePieces::evaluate(double u, double v) {
    const Patch& patch = at(u, v);
    const double x = (u - patch.middle[0]) * patch.scale[0];
    const double y = (v - patch.middle[1]) * patch.scale[1];
    const int degree = degree_[1];
    const Homogeneous* c = patch.coefficients.data() + patch.coefficients.size();
    Sums s;
    for (int i = degree_[0]; i >= 0; --i) {
        Homogeneous b0 = *--c;
        Homogeneous b1 = Homogeneous::Zero();
        Homogeneous b2 = Homogeneous::Zero();
        for (int k = 0; k < degree; ++k) {
            if (kSecond) {
                b2 = b2 * y + b1;
            }
            b1 = b1 * y + b0;
            b0 = b0 * y + *--c;
        }
        if (kSecond) {
            s.xx = s.xx * x + s.x;
            s.xy = s.xy * x + s.y;
            s.yy = s.yy * x + b2;
        }
        s.x = s.x * x + s.p;
        s.y = s.y * x + b1;
        s.p = s.p * x + b0;
    }
    const double du = patch.scale[0];
    const double dv = patch.scale[1];
    SurfacePoint r;
    r.point = s.p.head<3>();
    r.su = s.x.head<3>() * du;
    r.sv = s.y.head<3>() * dv;
    if (kSecond) {
        r.suu = s.xx.head<3>() * (2.0 * du * du);
        r.suv = s.xy.head<3>() * (du * dv);
        r.svv = s.yy.head<3>() * (2.0 * dv * dv);
    }
    if (!rational_) {
        return r;
    }
    // S = P / w: the derivatives of P = S w by the product rule, solved for those of S.
    const double w = 1.0 / s.p[3];
    const double wu = s.x[3] * du;
    const double wv = s.y[3] * dv;
    r.point *= w;
    r.su = (r.su - r.point * wu) * w;
    r.sv = (r.sv - r.point * wv) * w;
    if (kSecond) {
        r.suu = (r.suu - r.su * (2.0 * wu) - r.point * (s.xx[3] * (2.0 * du * du))) * w;
        r.suv = (r.suv - r.su * wv - r.sv * wu - r.point * (s.xy[3] * (du * dv))) * w;
        r.svv = (r.svv - r.sv * (2.0 * wv) - r.point * (s.yy[3] * (2.0 * dv * dv))) * w;
    }
    return r;
}

Vec3 SplineSurfacePieces::point(double u, double v) {
    const Patch& patch = at(u, v);
    const double x = (u - patch.middle[0]) * patch.scale[0];
    const double y = (v - patch.middle[1]) * patch.scale[1];
    const Homogeneous* c = patch.coefficients.data() + patch.coefficients.size();
    Homogeneous sum = Homogeneous::Zero();
    for (int i = degree_[0]; i >= 0; --i) {
        Homogeneous row = *--c;
        for (int k = 0; k < degree_[1]; ++k) {
            row = row * y + *--c;
        }
        sum = sum * x + row;
    }
    Vec3 result = sum.head<3>();
    if (rational_) {
        result *= 1.0 / sum[3];
    }
    return result;
}

SurfacePoint SplineSurfacePieces::first(double u, double v) {
    return evaluate<false>(u, v);
}

SurfacePoint SplineSurfacePieces::second(double u, double v) {
    return evaluate<true>(u, v);
}

}  // namespace mq::geometry
