// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

#include "base/vec.h"

namespace mq::geometry {

/// A straight line or a circle of unit speed times `radius`, in space or in a parameter domain.
template <class Vector>
struct Curve {
    bool round = false;
    Vector origin = Vector::Zero();
    Vector x = Vector::Zero();  ///< the direction of a line, the start of a circle
    Vector y = Vector::Zero();
    double radius = 1.0;

    Vector at(double t) const {
        return round ? Vector(origin + radius * (std::cos(t) * x + std::sin(t) * y)) : Vector(origin + t * x);
    }
    Vector derivative(double t) const { return round ? Vector(radius * (std::cos(t) * y - std::sin(t) * x)) : x; }
};
using Curve3 = Curve<Vec3>;
using Curve2 = Curve<Vec2>;

inline Curve2 line2(const Vec2& origin, const Vec2& direction) {
    Curve2 curve;
    curve.origin = origin;
    curve.x = direction;
    return curve;
}

inline Curve2 circle2(double radius) {
    Curve2 curve;
    curve.round = true;
    curve.x = Vec2(1.0, 0.0);
    curve.y = Vec2(0.0, 1.0);
    curve.radius = radius;
    return curve;
}

inline Curve3 circle3(const Vec3& center, const Vec3& x, const Vec3& y, double radius) {
    Curve3 curve;
    curve.round = true;
    curve.origin = center;
    curve.x = x;
    curve.y = y;
    curve.radius = radius;
    return curve;
}

}  // namespace mq::geometry
