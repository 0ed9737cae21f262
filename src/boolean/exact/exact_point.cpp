// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/exact/exact_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "base/double_double.h"
#include "base/predicates.h"

namespace mq::boolean {

namespace {

/// Relative spacing of double-precision numbers, the unit of the error bounds.
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

using ExactVec = std::array<Expansion, 3>;

ExactVec difference_of(const Vec3& a, const Vec3& b) {
    return {Expansion::difference(a.x(), b.x()), Expansion::difference(a.y(), b.y()),
            Expansion::difference(a.z(), b.z())};
}

ExactVec cross(const ExactVec& a, const ExactVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Expansion dot(const ExactVec& a, const ExactVec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

ExactVec normal(const PlanePoints& plane) {
    return cross(difference_of(plane[1], plane[0]), difference_of(plane[2], plane[0]));
}

/// normal . point, the constant of the plane's equation.
Expansion offset(const ExactVec& normal, const Vec3& point) {
    return normal[0].scaled(point.x()) + normal[1].scaled(point.y()) + normal[2].scaled(point.z());
}

/// The double nearest to the value, within one unit in the last place.
double nearest(const Expansion& value) {
    const Expansion compressed = value.compressed();
    return compressed.size() == 0 ? 0.0 : compressed[compressed.size() - 1];
}

double largest(double a, double b, double c) {
    return std::max({std::abs(a), std::abs(b), std::abs(c)});
}

bool on_plane(const Vec3& point, const PlanePoints& plane) {
    return mq::orient3d(plane[0], plane[1], plane[2], point) == 0;
}

bool on_line_through(const Vec3& point, const Vec3& p, const Vec3& q) {
    return mq::orient2d(p, q, point, 0) == 0 && mq::orient2d(p, q, point, 1) == 0 && mq::orient2d(p, q, point, 2) == 0;
}

/// The nearest doubles of a constructed point.
struct Approximation {
    Vec3 place = Vec3::Zero();
    double error = 0.0;  ///< bound for the error of each coordinate
    /// Whether the coordinates may be doubles: the rounding error is within the error of the arithmetic.
    bool may_be_exact = false;
};

}  // namespace

/// The construction of a point, and its coordinates as far as they were needed.
class ExactPoint::Construction {
  public:
    Construction(const Vec3& p, const Vec3& q, const PlanePoints& plane) : line_{p, q}, planes_{plane} {}
    Construction(const PlanePoints& a, const PlanePoints& b, const PlanePoints& c)
        : planes_{a, b, c}, on_line_(false) {}

    const std::array<Expansion, 4>& exact() const {
        std::call_once(known_, [this] { exact_ = std::make_unique<const std::array<Expansion, 4>>(compute()); });
        return *exact_;
    }

    /// Nothing if double-double arithmetic does not determine the nearest doubles.
    std::optional<Approximation> approximate() const {
        return on_line_ ? approximate_on_line() : approximate_on_planes();
    }

    /// Whether the point has exactly these coordinates.
    bool is(const Vec3& point) const {
        return on_line_ ? on_line_through(point, line_[0], line_[1]) && on_plane(point, planes_[0])
                        : on_plane(point, planes_[0]) && on_plane(point, planes_[1]) && on_plane(point, planes_[2]);
    }

    /// Whether the other point is the intersection of the same three planes: it is this one.
    bool is_same_intersection(const Construction& other) const {
        return !on_line_ && !other.on_line_ &&
               std::is_permutation(planes_.begin(), planes_.end(), other.planes_.begin());
    }

  private:
    std::array<Expansion, 4> compute() const { return on_line_ ? exact_on_line() : exact_on_planes(); }

    std::array<Expansion, 4> exact_on_line() const {
        const auto& [p, q] = line_;
        const ExactVec n = normal(planes_[0]);
        const Expansion at_p = dot(n, difference_of(p, planes_[0][0]));
        const Expansion at_q = dot(n, difference_of(q, planes_[0][0]));
        std::array<Expansion, 4> exact;
        for (int k = 0; k < 3; ++k) {
            exact[static_cast<std::size_t>(k)] = (at_q.scaled(p[k]) - at_p.scaled(q[k])).compressed();
        }
        exact[3] = (at_q - at_p).compressed();
        return exact;
    }

    std::array<Expansion, 4> exact_on_planes() const {
        const ExactVec n[3] = {normal(planes_[0]), normal(planes_[1]), normal(planes_[2])};
        const Expansion d[3] = {offset(n[0], planes_[0][0]), offset(n[1], planes_[1][0]), offset(n[2], planes_[2][0])};
        const ExactVec turned[3] = {cross(n[1], n[2]), cross(n[2], n[0]), cross(n[0], n[1])};
        std::array<Expansion, 4> exact;
        for (std::size_t k = 0; k < 3; ++k) {
            exact[k] = (d[0] * turned[0][k] + d[1] * turned[1][k] + d[2] * turned[2][k]).compressed();
        }
        exact[3] = dot(n[0], turned[0]).compressed();
        return exact;
    }

    /// p + s (q - p), where s = at_p / (at_p - at_q) is found from the distances of p and q from the plane.
    std::optional<Approximation> approximate_on_line() const {
        const auto& [p, q] = line_;
        const DoubleDoubleVec u = difference(planes_[0][1], planes_[0][0]);
        const DoubleDoubleVec v = difference(planes_[0][2], planes_[0][0]);
        const DoubleDoubleVec to_p = difference(p, planes_[0][0]);
        const DoubleDoubleVec to_q = difference(q, planes_[0][0]);
        const DoubleDoubleVec way = difference(q, p);
        const DoubleDoubleVec n = cross(u, v);
        const DoubleDouble at_p = dot(n, to_p);
        const DoubleDouble width = at_p - dot(n, to_q);
        const double error =
            kUnit * cross_of_magnitudes(magnitudes(u), magnitudes(v)).dot(magnitudes(to_p) + magnitudes(to_q));
        if (!(std::abs(width.high) > 2.0 * error)) {
            return std::nullopt;
        }
        const DoubleDouble s = at_p / width;
        const double error_of_s =
            2.0 * (1.0 + std::abs(s.high)) * error / std::abs(width.high) + kUnit * (1.0 + std::abs(s.high));
        DoubleDoubleVec place;
        for (std::size_t k = 0; k < 3; ++k) {
            place[k] = DoubleDouble(p[static_cast<int>(k)]) + s * way[k];
        }
        return within(place, error_of_s * magnitudes(way).maxCoeff() + kUnit * p.cwiseAbs().maxCoeff());
    }

    /// The solution of the three planes' equations by Cramer's rule, about a point of the first.
    std::optional<Approximation> approximate_on_planes() const {
        const Vec3& origin = planes_[0][0];
        DoubleDoubleVec n[3];
        Vec3 size[3];
        DoubleDouble d[3];
        double size_of_d[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const DoubleDoubleVec u = difference(planes_[i][1], planes_[i][0]);
            const DoubleDoubleVec v = difference(planes_[i][2], planes_[i][0]);
            const DoubleDoubleVec shift = difference(planes_[i][0], origin);
            n[i] = cross(u, v);
            size[i] = cross_of_magnitudes(magnitudes(u), magnitudes(v));
            d[i] = dot(n[i], shift);
            size_of_d[i] = size[i].dot(magnitudes(shift));
        }
        const DoubleDoubleVec turned[3] = {cross(n[1], n[2]), cross(n[2], n[0]), cross(n[0], n[1])};
        const Vec3 size_of_turned[3] = {cross_of_magnitudes(size[1], size[2]), cross_of_magnitudes(size[2], size[0]),
                                        cross_of_magnitudes(size[0], size[1])};
        const DoubleDouble w = dot(n[0], turned[0]);
        const double error_of_w = kUnit * size[0].dot(size_of_turned[0]);
        if (!(std::abs(w.high) > 2.0 * error_of_w)) {
            return std::nullopt;
        }
        DoubleDoubleVec place;
        double error = kUnit * origin.cwiseAbs().maxCoeff();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<int>(k);
            const DoubleDouble x = (d[1] * turned[1][k] + d[2] * turned[2][k]) / w;
            const double error_of_x =
                kUnit * (size_of_d[1] * size_of_turned[1][i] + size_of_d[2] * size_of_turned[2][i]);
            place[k] = DoubleDouble(origin[i]) + x;
            error += 2.0 * (error_of_x + std::abs(x.high) * error_of_w) / std::abs(w.high) + kUnit * std::abs(x.high);
        }
        return within(place, error);
    }

    /// A place whose coordinates have an error of at most `error`.
    static std::optional<Approximation> within(const DoubleDoubleVec& place, double error) {
        Approximation found;
        found.may_be_exact = true;
        for (std::size_t k = 0; k < 3; ++k) {
            found.place[static_cast<int>(k)] = place[k].high;
            found.may_be_exact = found.may_be_exact && std::abs(place[k].low) <= error;
        }
        const double unit = kEpsilon * found.place.cwiseAbs().maxCoeff();
        if (!(error <= unit)) {
            return std::nullopt;
        }
        found.error = 2.0 * unit;
        return found;
    }

    /// Bounds the relative error of at most twelve operations in a row, with a margin for that of the magnitudes.
    static constexpr double kUnit = 256.0 * 0x1p-106;

    std::array<Vec3, 2> line_;
    std::array<PlanePoints, 3> planes_;  ///< only the first, for a point on a line
    bool on_line_ = true;
    mutable std::once_flag known_;
    mutable std::unique_ptr<const std::array<Expansion, 4>> exact_;
};

ExactPoint::ExactPoint(std::shared_ptr<const Construction> construction) : construction_(std::move(construction)) {
    if (const auto found = construction_->approximate()) {
        approx_ = found->place;
        error_ = found->error;
        if (found->may_be_exact && construction_->is(approx_)) {
            error_ = 0.0;
            construction_ = nullptr;
        }
        return;
    }
    const std::array<Expansion, 4>& exact = construction_->exact();
    const double w = nearest(exact[3]);
    approx_ = Vec3(nearest(exact[0]) / w, nearest(exact[1]) / w, nearest(exact[2]) / w);
    // Numerator and denominator have an error of one unit each, and the quotient has its own rounding.
    error_ = 2.0 * kEpsilon * approx_.cwiseAbs().maxCoeff();
}

PlanePoints standing_plane(const Vec3& from, const Vec3& to, int axis) {
    Vec3 beside = from;
    beside[axis] = beside[axis] == 0.0 ? 1.0 : 2.0 * beside[axis];
    return {from, to, beside};
}

ExactPoint ExactPoint::on_line(const Vec3& p, const Vec3& q, const PlanePoints& plane) {
    return ExactPoint(std::make_shared<const Construction>(p, q, plane));
}

ExactPoint ExactPoint::on_planes(const PlanePoints& a, const PlanePoints& b, const PlanePoints& c) {
    return ExactPoint(std::make_shared<const Construction>(a, b, c));
}

std::array<Expansion, 4> ExactPoint::homogeneous() const {
    if (construction_) {
        return construction_->exact();
    }
    return {Expansion(approx_.x()), Expansion(approx_.y()), Expansion(approx_.z()), Expansion(1.0)};
}

bool ExactPoint::is_same_intersection(const ExactPoint& other) const {
    return construction_ && other.construction_ && construction_->is_same_intersection(*other.construction_);
}

namespace {

/// Sign of p - q along a coordinate axis if the approximations decide it.
std::optional<int> compare_approximations(const ExactPoint& p, const ExactPoint& q, int axis) {
    const double gap = p.approx()[axis] - q.approx()[axis];
    if (std::abs(gap) > 2.0 * (p.error() + q.error()) || (p.given() && q.given())) {
        return (gap > 0.0) - (gap < 0.0);
    }
    return std::nullopt;
}

int compare_exactly(const std::array<Expansion, 4>& a, const std::array<Expansion, 4>& b, int axis) {
    const auto k = static_cast<std::size_t>(axis);
    return (a[k] * b[3] - b[k] * a[3]).sign() * a[3].sign() * b[3].sign();
}

}  // namespace

int compare(const ExactPoint& p, const ExactPoint& q, int axis) {
    const std::optional<int> known = compare_approximations(p, q, axis);
    return known ? *known : compare_exactly(p.homogeneous(), q.homogeneous(), axis);
}

bool coincide(const ExactPoint& p, const ExactPoint& q) {
    std::array<std::optional<int>, 3> known;
    for (int axis = 0; axis < 3; ++axis) {
        known[static_cast<std::size_t>(axis)] = compare_approximations(p, q, axis);
        if (known[static_cast<std::size_t>(axis)].value_or(0) != 0) {
            return false;
        }
    }
    if ((known[0] && known[1] && known[2]) || p.is_same_intersection(q)) {
        return true;
    }
    const std::array<Expansion, 4> a = p.homogeneous();
    const std::array<Expansion, 4> b = q.homogeneous();
    return compare_exactly(a, b, 0) == 0 && compare_exactly(a, b, 1) == 0 && compare_exactly(a, b, 2) == 0;
}

int orient2d(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r, int axis) {
    if (p.given() && q.given() && r.given()) {
        return mq::orient2d(p.approx(), q.approx(), r.approx(), axis);
    }
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    const double ax = p.approx()[i] - r.approx()[i];
    const double ay = p.approx()[j] - r.approx()[j];
    const double bx = q.approx()[i] - r.approx()[i];
    const double by = q.approx()[j] - r.approx()[j];
    const double area = ax * by - ay * bx;
    const double size = std::max(largest(ax, ay, bx), std::abs(by));
    const double error = std::max({p.error(), q.error(), r.error()});
    // Each difference has the errors of two coordinates and one rounding, and is multiplied by a factor of at most
    // `size`.
    if (std::abs(area) > 10.0 * error * (size + error) + 8.0 * kEpsilon * size * size) {
        return area > 0.0 ? 1 : -1;
    }
    const auto u = static_cast<std::size_t>(i);
    const auto v = static_cast<std::size_t>(j);
    const std::array<Expansion, 4> a = p.homogeneous();
    const std::array<Expansion, 4> b = q.homogeneous();
    const std::array<Expansion, 4> c = r.homogeneous();
    const Expansion det =
        a[u] * (b[v] * c[3] - b[3] * c[v]) - a[v] * (b[u] * c[3] - b[3] * c[u]) + a[3] * (b[u] * c[v] - b[v] * c[u]);
    return det.sign() * a[3].sign() * b[3].sign() * c[3].sign();
}

int side_of(const PlanePoints& plane, const ExactPoint& p) {
    if (p.given()) {
        return mq::orient3d(plane[0], plane[1], plane[2], p.approx());
    }
    const Vec3 u = plane[1] - plane[0];
    const Vec3 v = plane[2] - plane[0];
    const Vec3 w = p.approx() - plane[0];
    const double volume = u.cross(v).dot(w);
    const double face = u.cwiseAbs().maxCoeff() * v.cwiseAbs().maxCoeff();
    // Error bound: 6 products of 3 differences with one rounding each, plus the error of the approximated point in the
    // third difference.
    if (std::abs(volume) > 8.0 * face * p.error() + 32.0 * kEpsilon * face * w.cwiseAbs().maxCoeff()) {
        return volume > 0.0 ? 1 : -1;
    }
    const ExactVec n = normal(plane);
    const std::array<Expansion, 4> h = p.homogeneous();
    const Expansion det = dot(n, {h[0], h[1], h[2]}) - offset(n, plane[0]) * h[3];
    return det.sign() * h[3].sign();
}

}  // namespace mq::boolean
