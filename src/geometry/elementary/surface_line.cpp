// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/elementary/surface_line.h"

#include <algorithm>
#include <cmath>

namespace mq::geometry {

namespace {

using Kind = ElementarySurface::Kind;

/// Pi, for the angles between the roots of a cubic.
constexpr double kPi = 3.14159265358979323846;

/// The coordinates of a vector along the axes of the surface.
Vec3 along_axes(const ElementarySurface& s, const Vec3& v) {
    return Vec3(v.dot(s.x), v.dot(s.y), v.dot(s.z));
}

/// Adds the roots of a t^2 + 2 b t + c, all moved by `shift`.
void add_quadratic(double a, double b, double c, double shift, LineRoots& roots) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) {
        return;
    }
    // The root of larger size first: no digits are lost to cancellation.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    std::array<double, 2> found{};
    int count = 0;
    if (a != 0.0 && std::isfinite(q / a)) {
        found[static_cast<std::size_t>(count++)] = q / a;
    }
    if (q != 0.0) {
        found[static_cast<std::size_t>(count++)] = c / q;
    } else if (a != 0.0) {
        found[static_cast<std::size_t>(count++)] = 0.0;
    }
    std::sort(found.begin(), found.begin() + count);
    for (int i = 0; i < count; ++i) {
        roots.add(shift + found[static_cast<std::size_t>(i)]);
    }
}

/// s^4 + c2 s^2 + c1 s + c0.
struct DepressedQuartic {
    double c2, c1, c0;

    double at(double s) const { return ((s * s + c2) * s + c1) * s + c0; }
    double slope(double s) const { return (4.0 * s * s + 2.0 * c2) * s + c1; }

    /// The places where the slope vanishes, ascending: roots of s^3 + p s + q.
    std::array<double, 3> extrema(int& count) const {
        const double p = 0.5 * c2, q = 0.25 * c1;
        const double discriminant = 0.25 * q * q + p * p * p / 27.0;
        std::array<double, 3> found{};
        if (discriminant >= 0.0) {
            const double root = std::sqrt(discriminant);
            const double larger = std::cbrt(-0.5 * q - std::copysign(root, q));
            found[0] = larger != 0.0 ? larger - p / (3.0 * larger) : 0.0;
            count = 1;
            return found;
        }
        const double size = 2.0 * std::sqrt(-p / 3.0);
        const double turn = std::acos(std::clamp(3.0 * q / (p * size), -1.0, 1.0)) / 3.0;
        for (int k = 0; k < 3; ++k) {
            found[static_cast<std::size_t>(k)] = size * std::cos(turn - 2.0 * kPi * k / 3.0);
        }
        std::sort(found.begin(), found.end());
        count = 3;
        return found;
    }

    /// The root between two places of different sign where the quartic is monotone: Newton's method within brackets.
    double root_between(double low, double high) const {
        // Number of steps in which bisection alone reaches the rounding of doubles.
        constexpr int kRootSteps = 60;
        // A step this short, as a fraction of the major radius, is rounding.
        constexpr double kLastStep = 2e-15;
        const bool rises = at(high) > 0.0;
        // The rounding of values between the brackets.
        const double far = std::max(std::abs(low), std::abs(high));
        const double zero = 2e-16 * (((far * far + std::abs(c2)) * far + std::abs(c1)) * far + std::abs(c0));
        double s = 0.5 * (low + high);
        for (int step = 0; step < kRootSteps; ++step) {
            const double value = at(s);
            if (std::abs(value) <= zero) {
                return s;
            }
            ((value > 0.0) == rises ? high : low) = s;
            const double next = s - value / slope(s);
            const double taken = next > low && next < high ? next : 0.5 * (low + high);
            if (std::abs(taken - s) <= kLastStep * (1.0 + std::abs(s))) {
                return taken;
            }
            s = taken;
        }
        return s;
    }
};

/// The line is measured from its point nearest to the centre, in units of the major radius: the coefficients are small
/// then, and that of the third power vanishes.
void add_torus_roots(const ElementarySurface& s, const Vec3& p, const Vec3& d, LineRoots& roots) {
    const double shift = -p.dot(d);
    const Vec3 q = (p + shift * d) / s.radius;
    const double ratio = s.minor / s.radius;
    const double reach = 1.0 + ratio;
    const double square = reach * reach - q.squaredNorm();
    if (square <= 0.0) {
        return;
    }
    const double k = q.squaredNorm() + 1.0 - ratio * ratio;
    const double a = d.x() * d.x() + d.y() * d.y();
    const double b = q.x() * d.x() + q.y() * d.y();
    const double c = q.x() * q.x() + q.y() * q.y();
    const DepressedQuartic quartic{2.0 * k - 4.0 * a, -8.0 * b, k * k - 4.0 * c};
    // All roots lie within the sphere around the torus; a little more leaves a sign on each side.
    const double end = std::sqrt(square) * (1.0 + 1e-9) + 1e-9;
    int count = 0;
    const std::array<double, 3> extrema = quartic.extrema(count);
    double from = -end;
    for (int i = 0; i <= count; ++i) {
        const double to = i < count ? std::clamp(extrema[static_cast<std::size_t>(i)], from, end) : end;
        if ((quartic.at(from) > 0.0) != (quartic.at(to) > 0.0)) {
            roots.add(shift + s.radius * quartic.root_between(from, to));
        }
        from = to;
    }
}

}  // namespace

LineRoots line_roots(const ElementarySurface& surface, const Vec3& origin, const Vec3& direction) {
    LineRoots roots;
    const Vec3 p = along_axes(surface, origin - surface.origin);
    const Vec3 d = along_axes(surface, direction);
    switch (surface.kind) {
        case Kind::Plane:
            if (d.z() != 0.0) {
                roots.add(-p.z() / d.z());
            }
            break;
        case Kind::Cylinder: {
            const double a = d.x() * d.x() + d.y() * d.y();
            // The parameter is measured from the point nearest to the axis, so that no digits are lost far from the
            // surface.
            const double shift = a > 0.0 ? -(p.x() * d.x() + p.y() * d.y()) / a : 0.0;
            const double x = p.x() + shift * d.x(), y = p.y() + shift * d.y();
            if (a > 0.0) {
                const double c = (std::hypot(x, y) - surface.radius) * (std::hypot(x, y) + surface.radius);
                add_quadratic(a, x * d.x() + y * d.y(), c, shift, roots);
            }
            break;
        }
        case Kind::Cone: {
            const double slope = std::tan(surface.angle);
            const double shift = -p.dot(d);
            const Vec3 q = p + shift * d;
            const double rho = surface.radius + q.z() * slope, rise = d.z() * slope;
            add_quadratic(d.x() * d.x() + d.y() * d.y() - rise * rise, q.x() * d.x() + q.y() * d.y() - rho * rise,
                          q.x() * q.x() + q.y() * q.y() - rho * rho, shift, roots);
            break;
        }
        case Kind::Sphere: {
            const double shift = -p.dot(d);
            const Vec3 q = p + shift * d;
            const double c = (q.norm() - surface.radius) * (q.norm() + surface.radius);
            add_quadratic(1.0, q.dot(d), c, shift, roots);
            break;
        }
        case Kind::Torus:
            add_torus_roots(surface, p, d, roots);
            break;
    }
    return roots;
}

Vec3 normal_near(const ElementarySurface& surface, const Vec3& point) {
    const Vec3 p = along_axes(surface, point - surface.origin);
    const double rho = std::hypot(p.x(), p.y());
    Vec3 n = Vec3::Zero();
    switch (surface.kind) {
        case Kind::Plane:
            n = Vec3::UnitZ();
            break;
        case Kind::Cylinder:
            n = Vec3(p.x(), p.y(), 0.0);
            break;
        case Kind::Cone: {
            const double slope = std::tan(surface.angle);
            n = Vec3(p.x(), p.y(), -(surface.radius + p.z() * slope) * slope);
            break;
        }
        case Kind::Sphere:
            n = p;
            break;
        case Kind::Torus:
            n = rho > 0.0 ? Vec3(p - surface.radius / rho * Vec3(p.x(), p.y(), 0.0)) : Vec3::Zero();
            break;
    }
    const double length = n.norm();
    // Lengths below this fraction of the radius define no direction.
    constexpr double kNoDirection = 1e-12;
    if (!(length > kNoDirection * std::max(std::abs(surface.radius), std::abs(surface.minor))) &&
        surface.kind != Kind::Plane) {
        return Vec3::Zero();
    }
    n /= length;
    return n.x() * surface.x + n.y() * surface.y + n.z() * surface.z;
}

}  // namespace mq::geometry
