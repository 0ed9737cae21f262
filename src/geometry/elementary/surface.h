// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>

#include "base/vec.h"

namespace mq::geometry {

/// A point of a surface with its derivatives.
struct SurfacePoint {
    Vec3 point = Vec3::Zero();
    Vec3 su = Vec3::Zero();
    Vec3 sv = Vec3::Zero();
    Vec3 suu = Vec3::Zero();
    Vec3 suv = Vec3::Zero();
    Vec3 svv = Vec3::Zero();
};

/// The nearest point of a surface.
struct SurfaceProjection {
    Vec2 uv = Vec2::Zero();
    SurfacePoint at;
};

/// A box of the parameter domain.
struct ParameterBox {
    std::array<double, 2> low{0.0, 0.0};
    std::array<double, 2> high{0.0, 0.0};
};

/// Plane, cylinder, cone, sphere and torus by formula, parametrised as OpenCASCADE does: u is the angle about `z` (on
/// the plane the coordinate along `x`); v is the coordinate along `y` (plane) or `z` (cylinder), the length along the
/// generator (cone), the latitude (sphere) or the angle in the tube (torus). The frame may be left-handed.
struct ElementarySurface {
    enum class Kind { Plane, Cylinder, Cone, Sphere, Torus };
    Kind kind = Kind::Plane;
    Vec3 origin = Vec3::Zero();
    Vec3 x = Vec3::UnitX();
    Vec3 y = Vec3::UnitY();
    Vec3 z = Vec3::UnitZ();
    double radius = 0.0;  ///< radius of the cylinder, the sphere, the cone at v = 0; major radius of the torus
    double minor = 0.0;   ///< minor radius of the torus
    double angle = 0.0;   ///< half angle of the cone, radians, signed

    SurfacePoint at(double u, double v) const;

    /// The point of the surface within `box` that is nearest to `p`; the box is no wider than a period. Where
    /// every u or v is equally near (on an axis) that of `guess` is taken. Empty where all points of the surface are
    /// equally near: at the centre of a sphere.
    std::optional<SurfaceProjection> nearest(const Vec3& p, const ParameterBox& box, const Vec2& guess) const;
};

/// `angle` moved by multiples of `period` into [near - period/2, near + period/2].
double branch_nearest(double angle, double near, double period);

}  // namespace mq::geometry
