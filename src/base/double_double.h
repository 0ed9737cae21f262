// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>

#include "base/vec.h"

namespace mq {

/// An unevaluated sum of two doubles, high + low with |low| at most half a unit in the last place of high: 106 bits.
/// Each operation has a relative error of at most 15 * 2^-106 (Joldes, Muller and Popescu 2017), unless it over- or
/// underflows.
struct DoubleDouble {
    double high = 0.0;
    double low = 0.0;

    DoubleDouble() = default;
    explicit DoubleDouble(double value) : high(value) {}
    /// a - b, exactly.
    static DoubleDouble difference(double a, double b) { return two_sum(a, -b); }

    DoubleDouble operator-() const {
        DoubleDouble result;
        result.high = -high;
        result.low = -low;
        return result;
    }
    friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const DoubleDouble s = two_sum(a.high, b.high);
        const DoubleDouble t = two_sum(a.low, b.low);
        const DoubleDouble v = fast_two_sum(s.high, s.low + t.high);
        return fast_two_sum(v.high, t.low + v.low);
    }
    friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + (-b); }
    friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        const double product = a.high * b.high;
        const double error = std::fma(a.high, b.high, -product);
        return fast_two_sum(product, error + std::fma(a.low, b.high, a.high * b.low));
    }
    friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
        const double quotient = a.high / b.high;
        const DoubleDouble rest = a - b * DoubleDouble(quotient);
        return fast_two_sum(quotient, rest.high / b.high);
    }

  private:
    static DoubleDouble two_sum(double a, double b) {
        DoubleDouble result;
        result.high = a + b;
        const double b_part = result.high - a;
        result.low = (a - (result.high - b_part)) + (b - b_part);
        return result;
    }
    /// two_sum for |a| >= |b| or a = 0.
    static DoubleDouble fast_two_sum(double a, double b) {
        DoubleDouble result;
        result.high = a + b;
        result.low = b - (result.high - a);
        return result;
    }
};

using DoubleDoubleVec = std::array<DoubleDouble, 3>;

inline DoubleDoubleVec difference(const Vec3& a, const Vec3& b) {
    return {DoubleDouble::difference(a.x(), b.x()), DoubleDouble::difference(a.y(), b.y()),
            DoubleDouble::difference(a.z(), b.z())};
}

inline DoubleDoubleVec cross(const DoubleDoubleVec& a, const DoubleDoubleVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline DoubleDouble dot(const DoubleDoubleVec& a, const DoubleDoubleVec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec3 magnitudes(const DoubleDoubleVec& a) {
    return {std::abs(a[0].high), std::abs(a[1].high), std::abs(a[2].high)};
}

/// The cross product with each product taken by its magnitude: rounding errors of `cross` are multiples of it.
inline Vec3 cross_of_magnitudes(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] + a[2] * b[1], a[2] * b[0] + a[0] * b[2], a[0] * b[1] + a[1] * b[0]};
}

}  // namespace mq
