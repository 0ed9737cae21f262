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

/// An angle with its cosine and sine.
struct Angle {
    double radians = 0.0;
    double cosine = 1.0;
    double sine = 0.0;
};

Angle angle_of(double radians) {
    return {radians, std::cos(radians), std::sin(radians)};
}

/// The angle in [low, high] nearest to `angle` on the circle.
Angle clamp_angle(const Angle& angle, double low, double high) {
    const double a = branch_nearest(angle.radians, 0.5 * (low + high), kTwoPi);
    const double within = std::clamp(a, low, high);
    return within == a ? Angle{a, angle.cosine, angle.sine} : angle_of(within);
}

/// The angle of the direction (x, y) of length `size`, as near as possible to it in [low, high]. Cosine and sine are
/// those of the direction itself: a projection needs no other trigonometric function than atan2.
Angle clamped_direction(double x, double y, double size, double low, double high) {
    return clamp_angle({std::atan2(y, x), x / size, y / size}, low, high);
}

SurfacePoint plane_at(const ElementarySurface& s, double u, double v) {
    SurfacePoint r;
    r.point = s.origin + u * s.x + v * s.y;
    r.su = s.x;
    r.sv = s.y;
    return r;
}

/// A point of a surface of revolution with radius rho(v) and height h(v), and its derivatives.
SurfacePoint revolved(const ElementarySurface& s, const Angle& u, const std::array<double, 3>& rho,
                      const std::array<double, 3>& height) {
    const Vec3 radial = u.cosine * s.x + u.sine * s.y;
    const Vec3 around = u.cosine * s.y - u.sine * s.x;
    SurfacePoint r;
    r.point = s.origin + rho[0] * radial + height[0] * s.z;
    r.su = rho[0] * around;
    r.sv = rho[1] * radial + height[1] * s.z;
    r.suu = -rho[0] * radial;
    r.suv = rho[1] * around;
    r.svv = rho[2] * radial + height[2] * s.z;
    return r;
}

/// The point of a surface with a straight generator, `v` along it.
SurfacePoint ruled_at(const ElementarySurface& s, const Angle& u, double v) {
    if (s.kind == ElementarySurface::Kind::Cylinder) {
        return revolved(s, u, {s.radius, 0.0, 0.0}, {v, 1.0, 0.0});
    }
    const double sine = std::sin(s.angle);
    const double cosine = std::cos(s.angle);
    return revolved(s, u, {s.radius + v * sine, sine, 0.0}, {v * cosine, cosine, 0.0});
}

/// The point of a surface whose generator is a circle: a sphere or a torus.
SurfacePoint round_at(const ElementarySurface& s, const Angle& u, const Angle& v) {
    const bool torus = s.kind == ElementarySurface::Kind::Torus;
    const double size = torus ? s.minor : s.radius;
    const double out = size * v.cosine;
    const double up = size * v.sine;
    return revolved(s, u, {torus ? s.radius + out : out, -up, -out}, {up, out, -up});
}

bool is_ruled(const ElementarySurface& s) {
    return s.kind == ElementarySurface::Kind::Cylinder || s.kind == ElementarySurface::Kind::Cone;
}

/// The point nearest to the one with the coordinates (rho, h) in the half plane at one angle u.
SurfaceProjection meridian_nearest(const ElementarySurface& s, const Angle& u, double rho, double h,
                                   const ParameterBox& box, double guess) {
    if (is_ruled(s)) {
        const double along =
            s.kind == ElementarySurface::Kind::Cone ? (rho - s.radius) * std::sin(s.angle) + h * std::cos(s.angle) : h;
        const double v = std::clamp(along, box.low[1], box.high[1]);
        return {Vec2(u.radians, v), ruled_at(s, u, v)};
    }
    const bool torus = s.kind == ElementarySurface::Kind::Torus;
    const double across = torus ? rho - s.radius : rho;
    const double distance = std::sqrt(across * across + h * h);
    const bool on_axis = distance <= kOnAxis * (torus ? s.minor : s.radius);
    const Angle v = on_axis ? angle_of(guess) : clamped_direction(across, h, distance, box.low[1], box.high[1]);
    return {Vec2(u.radians, v.radians), round_at(s, u, v)};
}

}  // namespace

double branch_nearest(double angle, double near, double period) {
    const bool far = period > 0.0 && std::abs(angle - near) > 0.5 * period;  // most angles are near
    return far ? angle - period * std::round((angle - near) / period) : angle;
}

SurfacePoint ElementarySurface::at(double u, double v) const {
    if (kind == Kind::Plane) {
        return plane_at(*this, u, v);
    }
    return is_ruled(*this) ? ruled_at(*this, angle_of(u), v) : round_at(*this, angle_of(u), angle_of(v));
}

std::optional<SurfaceProjection> ElementarySurface::nearest(const Vec3& p, const ParameterBox& box,
                                                            const Vec2& guess) const {
    const Vec3 d = p - origin;
    const double dx = d.dot(x);
    const double dy = d.dot(y);
    const double dz = d.dot(z);
    if (kind == Kind::Plane) {
        const Vec2 uv(std::clamp(dx, box.low[0], box.high[0]), std::clamp(dy, box.low[1], box.high[1]));
        return SurfaceProjection{uv, plane_at(*this, uv.x(), uv.y())};
    }
    const double rho = std::sqrt(dx * dx + dy * dy);
    if (kind == Kind::Sphere && std::hypot(rho, dz) <= kOnAxis * radius) {
        return std::nullopt;
    }
    // The cone has two nappes; on the one behind the apex, radii count negative.
    const double middle = 0.5 * (box.low[1] + box.high[1]);
    const double ahead = kind == Kind::Cone && radius + middle * std::sin(angle) < 0.0 ? -1.0 : 1.0;
    const double size = std::max(std::abs(radius), std::abs(dz));
    const Angle u = rho > kOnAxis * size ? clamped_direction(ahead * dx, ahead * dy, rho, box.low[0], box.high[0])
                                         : clamp_angle(angle_of(guess.x()), box.low[0], box.high[0]);
    return meridian_nearest(*this, u, dx * u.cosine + dy * u.sine, dz, box, guess.y());
}

}  // namespace mq::geometry
