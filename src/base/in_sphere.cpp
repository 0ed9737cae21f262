// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/in_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/double_double.h"
#include "base/expansion.h"
#include "base/lowest_bit.h"
#include "base/predicates.h"

namespace mq {
namespace {

/// The error of the determinant of in_sphere by the sum of the absolute values of its monomials, as predicates.cpp
/// derives it. A monomial takes five operations in the lift (two differences, a product, two sums), eight in the minor
/// of three rows, one for their product, and two sums: 16. One more covers sums of another order.
constexpr double kBound = (17 + 1) * 0.5 * std::numeric_limits<double>::epsilon();

using ExactVec = std::array<Expansion, 3>;

ExactVec exact_difference(const Vec3& a, const Vec3& b) {
    return {Expansion::difference(a.x(), b.x()), Expansion::difference(a.y(), b.y()),
            Expansion::difference(a.z(), b.z())};
}

Expansion exact_dot(const ExactVec& a, const ExactVec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The minors of the rows of x and y, and what in_sphere adds up of them.
struct SphereMinors {
    double ab, bc, cd, da, ac, bd;
};

/// The sign by double-doubles, or nothing where they do not decide. A monomial goes through eleven operations after the
/// exact differences: two in the minor, three to that of three rows, three in the lift, a product and two sums. The
/// determinant is a multiple of the product of the lowest bits of the coordinates and the square of the lowest of all.
std::optional<int> in_sphere_in_double_doubles(const std::array<const Vec3*, 4>& corners, const Vec3& e) {
    DoubleDouble value;
    double magnitude = 0.0;
    std::array<DoubleDoubleVec, 4> d;
    for (std::size_t i = 0; i < 4; ++i) {
        d[i] = difference(*corners[i], e);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const DoubleDoubleVec& p = d[(i + 1) % 4];
        const DoubleDoubleVec& q = d[(i + 2) % 4];
        const DoubleDoubleVec& r = d[(i + 3) % 4];
        const DoubleDouble term = dot(d[i], d[i]) * dot(p, cross(q, r));
        value = i % 2 == 0 ? value + term : value - term;
        magnitude += magnitudes(d[i]).squaredNorm() *
                     magnitudes(p).dot(cross_of_magnitudes(magnitudes(q), magnitudes(r)));
    }
    const double bound = 14.0 * 15.0 * 0x1p-106 * magnitude;
    if (std::abs(value.high) >= bound && value.high != 0.0) {
        return (value.high > 0.0 ? 1 : -1);
    }
    int unit = 0;
    int lowest = std::numeric_limits<double>::max_exponent;
    for (int i = 0; i < 3; ++i) {
        const int bit = lowest_bit({(*corners[0])[i], (*corners[1])[i], (*corners[2])[i], (*corners[3])[i], e[i]});
        unit += bit;
        lowest = std::min(lowest, bit);
    }
    return std::abs(value.high) + 2.0 * bound < std::ldexp(1.0, unit + 2 * lowest) ? std::optional(0) : std::nullopt;
}

int exact_in_sphere(const std::array<const Vec3*, 4>& corners, const Vec3& e) {
    if (const std::optional<int> sign = in_sphere_in_double_doubles(corners, e)) {
        return *sign;
    }
    std::array<ExactVec, 4> d;
    for (std::size_t i = 0; i < 4; ++i) {
        d[i] = exact_difference(*corners[i], e);
    }
    Expansion sum;
    for (std::size_t i = 0; i < 4; ++i) {
        const ExactVec& p = d[(i + 1) % 4];
        const ExactVec& q = d[(i + 2) % 4];
        const ExactVec& r = d[(i + 3) % 4];
        const ExactVec normal{(q[1] * r[2] - q[2] * r[1]).compressed(), (q[2] * r[0] - q[0] * r[2]).compressed(),
                              (q[0] * r[1] - q[1] * r[0]).compressed()};
        const Expansion term = exact_dot(d[i], d[i]).compressed() * exact_dot(p, normal).compressed();
        sum = i % 2 == 0 ? sum + term : sum - term;
    }
    return sum.sign();
}

}  // namespace

// The determinant of the rows (x, y, z, x^2 + y^2 + z^2) relative to e: four products of a lift and a minor of three rows.
int in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
    const std::array<Vec3, 4> r{a - e, b - e, c - e, d - e};
    const auto minor = [&](std::size_t i, std::size_t k) { return r[i].x() * r[k].y() - r[k].x() * r[i].y(); };
    const auto size = [&](std::size_t i, std::size_t k) {
        return std::abs(r[i].x() * r[k].y()) + std::abs(r[k].x() * r[i].y());
    };
    const SphereMinors m{minor(0, 1), minor(1, 2), minor(2, 3), minor(3, 0), minor(0, 2), minor(1, 3)};
    const SphereMinors s{size(0, 1), size(1, 2), size(2, 3), size(3, 0), size(0, 2), size(1, 3)};
    const std::array<double, 4> lift{r[0].squaredNorm(), r[1].squaredNorm(), r[2].squaredNorm(), r[3].squaredNorm()};
    const std::array<double, 4> z{std::abs(r[0].z()), std::abs(r[1].z()), std::abs(r[2].z()), std::abs(r[3].z())};
    const double bcd = r[1].z() * m.cd - r[2].z() * m.bd + r[3].z() * m.bc;
    const double cda = r[2].z() * m.da + r[3].z() * m.ac + r[0].z() * m.cd;
    const double dab = r[3].z() * m.ab + r[0].z() * m.bd + r[1].z() * m.da;
    const double abc = r[0].z() * m.bc - r[1].z() * m.ac + r[2].z() * m.ab;
    const double value = (lift[0] * bcd - lift[1] * cda) + (lift[2] * dab - lift[3] * abc);
    const double magnitude = lift[0] * (z[1] * s.cd + z[2] * s.bd + z[3] * s.bc) +
                             lift[1] * (z[2] * s.da + z[3] * s.ac + z[0] * s.cd) +
                             lift[2] * (z[3] * s.ab + z[0] * s.bd + z[1] * s.da) +
                             lift[3] * (z[0] * s.bc + z[1] * s.ac + z[2] * s.ab);
    PredicateCount& count = predicate_count();
    if (std::abs(value) >= kBound * magnitude) {
        ++count.filtered;
        return (value > 0.0) - (value < 0.0);
    }
    ++count.exact;
    return exact_in_sphere({&a, &b, &c, &d}, e);
}

}  // namespace mq
