// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/ray_crossings.h"

#include <algorithm>
#include <cmath>

#include "base/predicates.h"

namespace mq::inspection {

namespace {

/// A crossing within this fraction of the ray's length from its origin counts as at the origin: the origin is a rounded
/// point of a triangle.
constexpr double kAtOrigin = 1e-13;

/// The side on which the edge from v to w passes the ray from `origin` to `far`: positive where it runs
/// counter-clockwise around it. Zero only where the origin lies on the line of the edge.
int side_of_edge(const Vec3& origin, const Vec3& far, const Vec3& v, const Vec3& w) {
    int side = orient3d(origin, far, v, w);
    // The far point is moved by (e, e^2, e^3): the determinant is linear in the move.
    for (int axis = 0; side == 0 && axis < 3; ++axis) {
        side = orient2d(origin, v, w, axis);
    }
    return side;
}

}  // namespace

std::vector<Crossing> crossings_of(const mesh::AabbTree& tree, const std::vector<Vec3>& vertices,
                                   const std::vector<mesh::Triangle>& triangles, const Vec3& origin,
                                   const Vec3& direction, std::int32_t own) {
    std::vector<Crossing> found;
    const Box box = tree.box();
    if (box.empty()) {
        return found;
    }
    const double length = 2.0 * ((box.high - box.low).norm() + (origin - box.center()).norm());
    const Vec3 far = origin + length * direction;
    const Vec3 along = far - origin;
    tree.for_each_on_ray(origin, along, 1.0, [&](std::int32_t triangle) {
        if (triangle == own) {
            return;
        }
        const mesh::Triangle& t = triangles[triangle];
        const Vec3& a = vertices[t[0]];
        const Vec3& b = vertices[t[1]];
        const Vec3& c = vertices[t[2]];
        const int side = side_of_edge(origin, far, a, b);
        if (side == 0 || side_of_edge(origin, far, b, c) != side || side_of_edge(origin, far, c, a) != side) {
            return;
        }
        const bool leaves = side > 0;
        const Vec3 normal = (b - a).cross(c - a);
        const double speed = normal.dot(along);
        const double at = speed != 0.0 ? normal.dot(a - origin) / speed : 0.0;
        const int behind = leaves ? 1 : -1;
        const bool is_ahead = std::abs(at) > kAtOrigin ? orient3d(a, b, c, origin) != behind : leaves;
        if (is_ahead) {
            found.push_back({std::max(at, 0.0) * length, triangle, leaves});
        }
    });
    std::sort(found.begin(), found.end(), [](const Crossing& x, const Crossing& y) {
        if (x.distance != y.distance) {
            return x.distance < y.distance;
        }
        return x.leaves != y.leaves ? y.leaves : x.triangle < y.triangle;
    });
    return found;
}

int winding_at_start(const std::vector<Crossing>& crossings) {
    int winding = 0;
    for (const Crossing& crossing : crossings) {
        winding += crossing.leaves ? 1 : -1;
    }
    return winding;
}

}  // namespace mq::inspection
