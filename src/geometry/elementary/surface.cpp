// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/elementary/surface.h"

#include <algorithm>
#include <cmath>

namespace mq::geometry {

namespace {

/// Radians in a turn.
constexpr double kTwoPi = 6.283185307179586476925286766559;
/// Distances from an axis below this fraction of the dimensions leave the angle about it undefined.
constexpr double kOnAxis = 1e-14;

/// The angle in [low, high] nearest to `angle` on the circle.
double clamp_angle(double angle, double low, double high) {
    const double a = branch_nearest(angle, 0.5 * (low + high), kTwoPi);
    return std::clamp(a, low, high);
}

SurfacePoint plane_at(const ElementarySurface& s, double u, double v) {
    SurfacePoint r;
    r.point = s.origin + u * s.x + v * s.y;
    r.su = s.x;
    r.sv = s.y;
    return r;
}

/// A point of a surface of revolution with radius rho(v) and height h(v), and its derivatives.
SurfacePoint revolved(const ElementarySurface& s, double u, const std::array<double, 3>& rho,
                      const std::array<double, 3>& height) {
    const Vec3 radial = std::cos(u) * s.x + std::sin(u) * s.y;
    const Vec3 around = std::cos(u) * s.y - std::sin(u) * s.x;
    SurfacePoint r;
    r.point = s.origin + rho[0] * radial + height[0] * s.z;
    r.su = rho[0] * around;
    r.sv = rho[1] * radial + height[1] * s.z;
    r.suu = -rho[0] * radial;
    r.suv = rho[1] * around;
    r.svv = rho[2] * radial + height[2] * s.z;
    return r;
}

/// The parameter v of the point nearest to the point with the coordinates (rho, h) in the half plane at one angle u.
double meridian_nearest(const ElementarySurface& s, double rho, double h, const ParameterBox& box, double guess) {
    using Kind = ElementarySurface::Kind;
    switch (s.kind) {
        case Kind::Cone: {
            const double v = (rho - s.radius) * std::sin(s.angle) + h * std::cos(s.angle);
            return std::clamp(v, box.low[1], box.high[1]);
        }
        case Kind::Sphere:
        case Kind::Torus: {
            const double across = s.kind == Kind::Torus ? rho - s.radius : rho;
            const double size = s.kind == Kind::Torus ? s.minor : s.radius;
            if (std::hypot(across, h) <= kOnAxis * size) {
                return guess;
            }
            return clamp_angle(std::atan2(h, across), box.low[1], box.high[1]);
        }
        default:
            return std::clamp(h, box.low[1], box.high[1]);
    }
}

}  // namespace

double branch_nearest(double angle, double near, double period) {
    return period > 0.0 ? angle - period * std::round((angle - near) / period) : angle;
}

SurfacePoint ElementarySurface::at(double u, double v) const {
    switch (kind) {
        case Kind::Cylinder:
            return revolved(*this, u, {radius, 0.0, 0.0}, {v, 1.0, 0.0});
        case Kind::Cone:
            return revolved(*this, u, {radius + v * std::sin(angle), std::sin(angle), 0.0},
                            {v * std::cos(angle), std::cos(angle), 0.0});
        case Kind::Sphere:
            return revolved(*this, u, {radius * std::cos(v), -radius * std::sin(v), -radius * std::cos(v)},
                            {radius * std::sin(v), radius * std::cos(v), -radius * std::sin(v)});
        case Kind::Torus:
            return revolved(*this, u, {radius + minor * std::cos(v), -minor * std::sin(v), -minor * std::cos(v)},
                            {minor * std::sin(v), minor * std::cos(v), -minor * std::sin(v)});
        case Kind::Plane:
            break;
    }
    return plane_at(*this, u, v);
}

std::optional<Vec2> ElementarySurface::nearest(const Vec3& p, const ParameterBox& box, const Vec2& guess) const {
    const Vec3 d = p - origin;
    const double dx = d.dot(x);
    const double dy = d.dot(y);
    const double dz = d.dot(z);
    if (kind == Kind::Plane) {
        return Vec2(std::clamp(dx, box.low[0], box.high[0]), std::clamp(dy, box.low[1], box.high[1]));
    }
    const double rho = std::hypot(dx, dy);
    if (kind == Kind::Sphere && std::hypot(rho, dz) <= kOnAxis * radius) {
        return std::nullopt;
    }
    // The cone has two nappes; on the one behind the apex, radii count negative.
    const double middle = 0.5 * (box.low[1] + box.high[1]);
    const bool behind = kind == Kind::Cone && radius + middle * std::sin(angle) < 0.0;
    const double size = std::max(std::abs(radius), std::abs(dz));
    double u = guess.x();
    if (rho > kOnAxis * size) {
        u = behind ? std::atan2(-dy, -dx) : std::atan2(dy, dx);
    }
    u = clamp_angle(u, box.low[0], box.high[0]);
    const double along = dx * std::cos(u) + dy * std::sin(u);
    return Vec2(u, meridian_nearest(*this, along, dz, box, guess.y()));
}

}  // namespace mq::geometry
