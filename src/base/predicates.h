// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "base/vec.h"

/// Exact predicates: a floating-point filter with a proven error bound first, expansion arithmetic second.
///
/// All of them take the coordinates as exact numbers and return the sign of the true value. They are exact as long as
/// no intermediate product over- or underflows: coordinates of magnitude 1e-15 to 1e15 (or 0) are safe.
namespace mq {

/// The numbers of decisions by the filter and by exact arithmetic. One counter for each working thread.
struct PredicateCount {
    std::uint64_t filtered = 0;
    std::uint64_t exact = 0;

    PredicateCount& operator+=(const PredicateCount& other) {
        filtered += other.filtered;
        exact += other.exact;
        return *this;
    }
};

/// Counters of the calling thread.
PredicateCount& predicate_count();

/// Sign of (a - o) . (b - o): negative when the angle at o is obtuse.
int sign_dot(const Vec3& o, const Vec3& a, const Vec3& b);

/// Φ_obtuse (Aftosmis 1999, eq. 5): the index 0..2 of the vertex with an obtuse angle, -1 when there is none.
int obtuse_vertex(const Vec3& a, const Vec3& b, const Vec3& c);

/// Φ_encroached (section 3.1): p lies strictly inside the diametral sphere of the constraining edge from o to d.
bool encroached(const Vec3& o, const Vec3& d, const Vec3& p);

/// Φ_XN (section 3.4): the edge p-q shared by the triangles (p, q, r) and (q, p, s) is locally maxmin, that is, the
/// smallest angle of the two triangles is at least that of the swapped pair (r, s, q), (s, r, p). Exact.
bool locally_maxmin(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s);

/// Sign of the area of (a, b, c) in the plane: positive when counter-clockwise. Exact.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// The orientation in the plane of the axes (axis + 1, axis + 2), modulo 3: space seen against the axis. Exact.
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

/// a, b and c lie on one line, or some of them coincide: the triangle has no area. Exact.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// Sign of ((b - a) x (c - a)) . (d - a): positive when d lies on the side of the plane to which the normal of the
/// triangle (a, b, c) points, that is, from where the triangle is seen counter-clockwise; 0 when all four are coplanar
/// or (a, b, c) is degenerate. Exact.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Positive when d lies inside the circle through a, b, c, which run counter-clockwise. Exact.
int in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Positive when e lies inside the sphere through a, b, c, d, whose orient3d is positive; 0 on the sphere. Exact.
int in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace mq
