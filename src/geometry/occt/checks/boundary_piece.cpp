// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/checks/boundary_piece.h"

#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mq::geometry {

namespace {

using Controls = std::vector<Vec2>;

Vec2 to_vec(const gp_Pnt2d& p) {
    return Vec2(p.X(), p.Y());
}

/// Halvings of a polynomial or an arc at most.
constexpr int kHalvings = 8;

/// Points times their weights, and the weights.
using Weighted = std::vector<Vec3>;

Controls without_weights(const Weighted& points) {
    Controls result;
    for (const Vec3& p : points) {
        result.emplace_back(p.x() / p.z(), p.y() / p.z());
    }
    return result;
}

/// The control points of a polynomial of a B-spline: its blossom at both ends of the range, each as often as it takes.
Weighted bezier(const Weighted& poles, const std::vector<double>& knots, double from, double to) {
    const std::size_t degree = poles.size() - 1;
    Weighted result;
    for (std::size_t j = 0; j <= degree; ++j) {
        Weighted d = poles;
        for (std::size_t step = 1; step <= degree; ++step) {
            const double t = step <= degree - j ? from : to;
            for (std::size_t i = degree; i >= step; --i) {
                const double low = knots[i - 1];
                const double high = knots[i + degree - step];
                d[i] = ((high - t) * d[i - 1] + (t - low) * d[i]) / (high - low);
            }
        }
        result.push_back(d[degree]);
    }
    return result;
}

/// Whether the control points go on from start to end, within 18 degrees of the chord.
bool turns_little(const Controls& controls) {
    constexpr double kLeastCosine = 0.95;  // Cosine.
    const Vec2 chord = controls.back() - controls.front();
    if (!(chord.norm() > 0.0)) {
        return false;
    }
    for (std::size_t k = 1; k < controls.size(); ++k) {
        const Vec2 step = controls[k] - controls[k - 1];
        if (!(step.dot(chord) >= kLeastCosine * step.norm() * chord.norm())) {
            return false;
        }
    }
    return true;
}

/// Adds a polynomial, halved until each piece turns little, at most `most` times.
void add_halves(const Weighted& whole, int most, std::vector<Controls>& pieces) {
    Controls controls = without_weights(whole);
    if (most == 0 || turns_little(controls)) {
        pieces.push_back(std::move(controls));
        return;
    }
    Weighted first = whole;  // De Casteljau's algorithm.
    Weighted second = whole;
    for (std::size_t k = 1; k < whole.size(); ++k) {
        for (std::size_t i = whole.size() - 1; i >= k; --i) {
            first[i] = 0.5 * (first[i - 1] + first[i]);
        }
        for (std::size_t i = 0; i + k < whole.size(); ++i) {
            second[i] = 0.5 * (second[i] + second[i + 1]);
        }
    }
    add_halves(first, most - 1, pieces);
    add_halves(second, most - 1, pieces);
}

/// Adds an arc of a conic, halved until each piece turns little, at most `most` times.
void add_arcs(const Geom2d_Curve& conic, double from, double to, int most, std::vector<Controls>& arcs) {
    gp_Pnt2d start;
    gp_Vec2d along;
    conic.D1(from, start, along);
    const double reach = std::tan(0.5 * (to - from));
    Controls arc{to_vec(start), to_vec(start) + reach * Vec2(along.X(), along.Y()), to_vec(conic.Value(to))};
    if (most == 0 || turns_little(arc)) {
        arcs.push_back(std::move(arc));
        return;
    }
    const double middle = 0.5 * (from + to);
    add_arcs(conic, from, middle, most - 1, arcs);
    add_arcs(conic, middle, to, most - 1, arcs);
}

/// The range of points along an axis.
std::pair<double, double> range_along(const Controls& points, const Vec2& axis) {
    std::pair<double, double> range(points.front().dot(axis), points.front().dot(axis));
    for (const Vec2& p : points) {
        const double at = p.dot(axis);
        range = {std::min(range.first, at), std::max(range.second, at)};
    }
    return range;
}

}  // namespace

std::vector<BoundaryPiece> BoundaryPiece::of(const Handle(Geom2d_Curve) & curve, double first, double last,
                                             bool forward) {
    Handle(Geom2d_Curve) basis = curve;
    while (basis->DynamicType() == STANDARD_TYPE(Geom2d_TrimmedCurve)) {
        basis = Handle(Geom2d_TrimmedCurve)::DownCast(basis)->BasisCurve();
    }
    std::vector<Controls> found;
    if (basis->DynamicType() == STANDARD_TYPE(Geom2d_Line)) {
        found = {{to_vec(basis->Value(first)), to_vec(basis->Value(last))}};
    } else if (basis->DynamicType() == STANDARD_TYPE(Geom2d_Circle) ||
               basis->DynamicType() == STANDARD_TYPE(Geom2d_Ellipse)) {
        found = of_conic(*basis, first, last);
    } else if (basis->DynamicType() == STANDARD_TYPE(Geom2d_BSplineCurve)) {
        found = of_spline(*Handle(Geom2d_BSplineCurve)::DownCast(basis), first, last);
    }
    std::vector<BoundaryPiece> pieces(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (!forward) {
            std::reverse(found[k].begin(), found[k].end());
        }
        if (!pieces[forward ? k : found.size() - 1 - k].set(std::move(found[k]))) {
            return {};
        }
    }
    return pieces;
}

/// Arcs of at most 30 degrees, halved until each turns little: the tangents at the ends of each meet in its second
/// control point.
std::vector<BoundaryPiece::Controls> BoundaryPiece::of_conic(const Geom2d_Curve& conic, double first, double last) {
    constexpr double kLargestArc = M_PI / 6.0;
    const int count = std::max(1, static_cast<int>(std::ceil((last - first) / kLargestArc - 1e-9)));
    std::vector<Controls> arcs;
    for (int i = 0; i < count; ++i) {
        const double from = first + (last - first) * i / count;
        const double to = i + 1 < count ? first + (last - first) * (i + 1) / count : last;
        add_arcs(conic, from, to, kHalvings, arcs);
    }
    return arcs;
}

std::vector<BoundaryPiece::Controls> BoundaryPiece::of_spline(const Geom2d_BSplineCurve& spline, double first,
                                                              double last) {
    const int degree = spline.Degree();
    const TColStd_Array1OfReal& knots = spline.KnotSequence();
    // Relative difference of an end from a knot that is rounding.
    const double slack = 1e-9 * (last - first);
    if (spline.IsPeriodic() || first < knots(degree + 1) - slack || last > knots(spline.NbPoles() + 1) + slack) {
        return {};
    }
    std::vector<Controls> pieces;
    for (int i = degree + 1; i <= spline.NbPoles(); ++i) {  // the polynomial between this knot and the next one
        const double from = std::max(knots(i), first);
        const double to = std::min(knots(i + 1), last);
        if (!(to - from > slack)) {
            continue;
        }
        Weighted poles;
        std::vector<double> around;  // the knots on which the polynomial depends
        for (int k = i - degree; k <= i; ++k) {
            const gp_Pnt2d pole = spline.Pole(k);
            const double weight = spline.Weight(k);
            if (!(weight > 0.0)) {
                return {};
            }
            poles.emplace_back(weight * pole.X(), weight * pole.Y(), weight);
        }
        for (int k = i - degree + 1; k <= i + degree; ++k) {
            around.push_back(knots(k));
        }
        add_halves(bezier(poles, around, from, to), kHalvings, pieces);
    }
    return pieces;
}

/// False where the piece has no direction at an end, or turns much.
bool BoundaryPiece::set(Controls controls) {
    controls_ = std::move(controls);
    const std::size_t n = controls_.size();
    low_ = high_ = controls_.front();
    for (const Vec2& p : controls_) {
        low_ = low_.cwiseMin(p);
        high_ = high_.cwiseMax(p);
    }
    const double least = 1e-9 * (high_ - low_).norm();  // fraction of the size that may be rounding
    start_direction_ = controls_[1] - controls_[0];
    end_direction_ = controls_[n - 1] - controls_[n - 2];
    if (!(start_direction_.norm() > least) || !(end_direction_.norm() > least)) {
        return false;
    }
    start_direction_.normalize();
    end_direction_.normalize();
    return turns_little(controls_);
}

double BoundaryPiece::height() const {
    const Vec2 chord = (end() - start()).normalized();
    double most = 0.0;
    for (const Vec2& p : controls_) {
        most = std::max(most, std::abs(cross(chord, p - start())));
    }
    return most;
}

bool BoundaryPiece::ascends(const Vec2& direction) const {
    // Rounding of a difference, as a fraction of its length.
    constexpr double kDifferenceRounding = 1e-12;
    for (std::size_t k = 1; k < controls_.size(); ++k) {
        const Vec2 step = controls_[k] - controls_[k - 1];
        if (step.dot(direction) < -kDifferenceRounding * step.norm()) {
            return false;
        }
    }
    return true;
}

bool BoundaryPiece::is_apart_from(const BoundaryPiece& other, double margin) const {
    if (((low_ - other.high_).array() > margin).any() || ((other.low_ - high_).array() > margin).any()) {
        return true;
    }
    for (const Vec2& way : {Vec2(end() - start()), Vec2(other.end() - other.start())}) {
        const double size = way.norm();
        for (const Vec2& axis : {way, Vec2(-way.y(), way.x())}) {
            const auto here = range_along(controls_, axis);
            const auto there = range_along(other.controls_, axis);
            if (here.first - there.second > margin * size || there.first - here.second > margin * size) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace mq::geometry
