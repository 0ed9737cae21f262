// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/exact_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/predicates.h"

namespace mq::boolean {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// mq::orient3d is minus the determinant of the rows (x, y, z, 1).
constexpr int kDeterminantSign = -1;

using ExactVec = std::array<Expansion, 3>;

ExactVec difference(const Vec3& a, const Vec3& b) {
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
    return cross(difference(plane[1], plane[0]), difference(plane[2], plane[0]));
}

/// normal . point, the constant of the plane's equation.
Expansion offset(const ExactVec& normal, const Vec3& point) {
    return normal[0].scaled(point.x()) + normal[1].scaled(point.y()) + normal[2].scaled(point.z());
}

/// Within one unit in the last place.
double nearest(const Expansion& value) {
    const Expansion compressed = value.compressed();
    return compressed.size() == 0 ? 0.0 : compressed[compressed.size() - 1];
}

double largest(double a, double b, double c) {
    return std::max({std::abs(a), std::abs(b), std::abs(c)});
}

}  // namespace

ExactPoint::ExactPoint(std::array<Expansion, 4>&& exact) {
    const double w = nearest(exact[3]);
    approx_ = Vec3(nearest(exact[0]) / w, nearest(exact[1]) / w, nearest(exact[2]) / w);
    // Two quotients' operands within one unit each, and the quotient's own rounding.
    error_ = 2.0 * kEpsilon * approx_.cwiseAbs().maxCoeff();
    exact_ = std::make_shared<const std::array<Expansion, 4>>(std::move(exact));
}

PlanePoints standing_plane(const Vec3& from, const Vec3& to, int axis) {
    Vec3 beside = from;
    beside[axis] = beside[axis] == 0.0 ? 1.0 : 2.0 * beside[axis];
    return {from, to, beside};
}

ExactPoint ExactPoint::on_line(const Vec3& p, const Vec3& q, const PlanePoints& plane) {
    const ExactVec n = normal(plane);
    const Expansion at_p = dot(n, difference(p, plane[0]));
    const Expansion at_q = dot(n, difference(q, plane[0]));
    std::array<Expansion, 4> exact;
    for (int k = 0; k < 3; ++k) {
        exact[static_cast<std::size_t>(k)] = (at_q.scaled(p[k]) - at_p.scaled(q[k])).compressed();
    }
    exact[3] = (at_q - at_p).compressed();
    return ExactPoint(std::move(exact));
}

ExactPoint ExactPoint::on_planes(const PlanePoints& a, const PlanePoints& b, const PlanePoints& c) {
    const ExactVec n[3] = {normal(a), normal(b), normal(c)};
    const Expansion d[3] = {offset(n[0], a[0]), offset(n[1], b[0]), offset(n[2], c[0])};
    const ExactVec turned[3] = {cross(n[1], n[2]), cross(n[2], n[0]), cross(n[0], n[1])};
    std::array<Expansion, 4> exact;
    for (std::size_t k = 0; k < 3; ++k) {
        exact[k] = (d[0] * turned[0][k] + d[1] * turned[1][k] + d[2] * turned[2][k]).compressed();
    }
    exact[3] = dot(n[0], turned[0]).compressed();
    return ExactPoint(std::move(exact));
}

std::array<Expansion, 4> ExactPoint::homogeneous() const {
    if (exact_) {
        return *exact_;
    }
    return {Expansion(approx_.x()), Expansion(approx_.y()), Expansion(approx_.z()), Expansion(1.0)};
}

int compare(const ExactPoint& p, const ExactPoint& q, int axis) {
    const double gap = p.approx()[axis] - q.approx()[axis];
    if (std::abs(gap) > 2.0 * (p.error() + q.error()) || (p.given() && q.given())) {
        return (gap > 0.0) - (gap < 0.0);
    }
    const auto k = static_cast<std::size_t>(axis);
    const std::array<Expansion, 4> a = p.homogeneous();
    const std::array<Expansion, 4> b = q.homogeneous();
    return (a[k] * b[3] - b[k] * a[3]).sign() * a[3].sign() * b[3].sign();
}

bool coincide(const ExactPoint& p, const ExactPoint& q) {
    return compare(p, q, 0) == 0 && compare(p, q, 1) == 0 && compare(p, q, 2) == 0;
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
    // Each difference is wrong by 2 errors and a rounding, which the other factor, at most `size`, magnifies.
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

int orient3d(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r, const ExactPoint& s) {
    if (p.given() && q.given() && r.given() && s.given()) {
        return mq::orient3d(p.approx(), q.approx(), r.approx(), s.approx());
    }
    const Vec3 a = p.approx() - s.approx();
    const Vec3 b = q.approx() - s.approx();
    const Vec3 c = r.approx() - s.approx();
    const double volume = a.dot(b.cross(c));
    const double size = std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
    const double error = std::max({p.error(), q.error(), r.error(), s.error()});
    // Six products of three differences, each of them wrong by 2 errors and a rounding.
    const double reach = size + 2.0 * error;
    if (std::abs(volume) > 40.0 * error * reach * reach + 32.0 * kEpsilon * size * size * size) {
        return volume > 0.0 ? kDeterminantSign : -kDeterminantSign;
    }
    const std::array<std::array<Expansion, 4>, 4> m{p.homogeneous(), q.homogeneous(), r.homogeneous(), s.homogeneous()};
    // Laplace's expansion by the first two and the last two rows.
    const auto minor = [&](std::size_t row, std::size_t i, std::size_t j) {
        return m[row][i] * m[row + 1][j] - m[row][j] * m[row + 1][i];
    };
    const Expansion det = minor(0, 0, 1) * minor(2, 2, 3) - minor(0, 0, 2) * minor(2, 1, 3) +
                          minor(0, 0, 3) * minor(2, 1, 2) + minor(0, 1, 2) * minor(2, 0, 3) -
                          minor(0, 1, 3) * minor(2, 0, 2) + minor(0, 2, 3) * minor(2, 0, 1);
    return kDeterminantSign * det.sign() * m[0][3].sign() * m[1][3].sign() * m[2][3].sign() * m[3][3].sign();
}

}  // namespace mq::boolean
