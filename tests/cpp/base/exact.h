// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>

#include "base/expansion.h"
#include "base/vec.h"

/// The predicates by their definitions, in rational arithmetic.
namespace mq::exact {

using Vector = std::array<mpq_class, 3>;

inline Vector difference(const Vec3& a, const Vec3& b) {
    Vector d;
    for (int i = 0; i < 3; ++i) {
        d[i] = mpq_class(a[i]) - mpq_class(b[i]);
    }
    return d;
}

inline mpq_class dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline mpq_class value(const Expansion& e) {
    mpq_class sum = 0;
    for (std::size_t i = 0; i < e.size(); ++i) {
        sum += mpq_class(e[i]);
    }
    return sum;
}

inline int sign_dot(const Vec3& o, const Vec3& a, const Vec3& b) {
    return sgn(dot(difference(a, o), difference(b, o)));
}

/// cos |cos| of the angle a-o-b, which falls as the angle grows; 1 when an arm has no length.
inline mpq_class cosine_measure(const Vec3& a, const Vec3& o, const Vec3& b) {
    const Vector to_a = difference(a, o);
    const Vector to_b = difference(b, o);
    const mpq_class arms = dot(to_a, to_a) * dot(to_b, to_b);
    if (arms == 0) {
        return 1;
    }
    const mpq_class product = dot(to_a, to_b);
    return product * abs(product) / arms;
}

inline mpq_class largest_measure(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::max({cosine_measure(c, a, b), cosine_measure(a, b, c), cosine_measure(b, c, a)});
}

inline bool locally_maxmin(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    return std::max(largest_measure(p, q, r), largest_measure(q, p, s)) <=
           std::max(largest_measure(r, s, q), largest_measure(s, r, p));
}

inline mpq_class determinant(const mpq_class& a, const mpq_class& b, const mpq_class& c, const mpq_class& d) {
    return a * d - b * c;
}

inline int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
    const mpq_class x(c.x());
    const mpq_class y(c.y());
    return sgn(determinant(a.x() - x, a.y() - y, b.x() - x, b.y() - y));
}

inline Vector cross(const Vector& u, const Vector& v) {
    return {determinant(u[1], u[2], v[1], v[2]), determinant(u[2], u[0], v[2], v[0]),
            determinant(u[0], u[1], v[0], v[1])};
}

inline bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
    return cross(difference(b, a), difference(c, a)) == Vector{0, 0, 0};
}

/// Sign of ((b - a) x (c - a)) . (d - a).
inline int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return sgn(dot(cross(difference(b, a), difference(c, a)), difference(d, a)));
}

inline int in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    std::array<mpq_class, 3> x;
    std::array<mpq_class, 3> y;
    std::array<mpq_class, 3> lift;
    const std::array<Vec2, 3> corners{a, b, c};
    for (int i = 0; i < 3; ++i) {
        x[i] = mpq_class(corners[i].x()) - mpq_class(d.x());
        y[i] = mpq_class(corners[i].y()) - mpq_class(d.y());
        lift[i] = x[i] * x[i] + y[i] * y[i];
    }
    return sgn(mpq_class(lift[0] * determinant(x[1], y[1], x[2], y[2]) + lift[1] * determinant(x[2], y[2], x[0], y[0]) +
                         lift[2] * determinant(x[0], y[0], x[1], y[1])));
}

/// Minus the determinant of the rows (x, y, z, x^2 + y^2 + z^2) relative to e, by its permutations.
inline int in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
    std::array<std::array<mpq_class, 4>, 4> rows;
    const std::array<Vec3, 4> corners{a, b, c, d};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector to = difference(corners[i], e);
        rows[i] = {to[0], to[1], to[2], dot(to, to)};
    }
    std::array<std::size_t, 4> column{0, 1, 2, 3};
    mpq_class sum = 0;
    do {
        mpq_class product = 1;
        for (std::size_t i = 0; i < 4; ++i) {
            product *= rows[i][column[i]];
            for (std::size_t k = 0; k < i; ++k) {
                product *= column[k] > column[i] ? -1 : 1;
            }
        }
        sum += product;
    } while (std::next_permutation(column.begin(), column.end()));
    return -sgn(sum);
}

}  // namespace mq::exact
