// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include "geometry/elementary/surface.h"

namespace mq::geometry {

/// The points that a line has in common with a surface, by their parameters along the line, in ascending order.
struct LineRoots {
    std::array<double, 4> t{};
    int count = 0;

    void add(double root) { t[static_cast<std::size_t>(count++)] = root; }
};

/// The points of the line `origin` + t `direction` on the unbounded surface (both nappes of a cone), in closed form;
/// for the torus the roots of a quartic between its extrema. A tangent line has two equal points, or none if rounding
/// moves it past the surface. A line that lies in the surface has none.
/// @param direction a unit vector
LineRoots line_roots(const ElementarySurface& surface, const Vec3& origin, const Vec3& direction);

/// The unit normal of the surface at a point near it, along the gradient of the distance from its axis or plane (from
/// the circle in its tube for a torus); zero where there is none: at the apex of a cone, on an axis, at a centre.
Vec3 normal_near(const ElementarySurface& surface, const Vec3& point);

}  // namespace mq::geometry
