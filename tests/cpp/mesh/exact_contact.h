// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "base/exact.h"
#include "mesh/intersection/triangle_contact.h"

/// The contact of two triangles by its definition: their intersection, a convex set, by clipping in rational
/// arithmetic. It shares no code or idea with mesh::contact.
namespace mq::exact {

using Polygon = std::vector<Vector>;  ///< convex; may be a segment or a point; points may repeat

inline Vector exact_point(const Vec3& p) {
    return {mpq_class(p.x()), mpq_class(p.y()), mpq_class(p.z())};
}

inline Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The points with normal . (p - origin) >= 0.
inline Polygon clipped(const Polygon& polygon, const Vector& origin, const Vector& normal) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector& a = polygon[i];
        const Vector& b = polygon[(i + 1) % polygon.size()];
        const mpq_class a_height = dot(normal, minus(a, origin));
        const mpq_class b_height = dot(normal, minus(b, origin));
        if (a_height >= 0) {
            kept.push_back(a);
        }
        if (sgn(a_height) * sgn(b_height) < 0) {
            const mpq_class t = a_height / (a_height - b_height);
            kept.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
        }
    }
    return kept;
}

inline Vector negated(const Vector& v) {
    return {-v[0], -v[1], -v[2]};
}

/// Strictly inside the triangle's edges, for a point of its plane.
inline bool inside(const Vector& p, const Polygon& t) {
    const Vector normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    for (int i = 0; i < 3; ++i) {
        const Vector& a = t[i];
        if (dot(cross(normal, minus(t[(i + 1) % 3], a)), minus(p, a)) <= 0) {
            return false;
        }
    }
    return true;
}

inline Polygon intersection(const Polygon& p, const Polygon& q) {
    const Vector normal = cross(minus(q[1], q[0]), minus(q[2], q[0]));
    Polygon common = clipped(clipped(p, q[0], normal), q[0], negated(normal));
    for (int i = 0; i < 3; ++i) {
        common = clipped(common, q[i], cross(normal, minus(q[(i + 1) % 3], q[i])));
    }
    return common;
}

/// Every point of the set lies in the hull of `shared`: none, a point, or a segment.
inline bool within(const Polygon& set, const Polygon& shared) {
    return std::all_of(set.begin(), set.end(), [&](const Vector& x) {
        if (shared.size() < 2) {
            return !shared.empty() && x == shared[0];
        }
        const Vector to_first = minus(shared[0], x);
        const Vector to_second = minus(shared[1], x);
        return cross(to_first, to_second) == Vector{0, 0, 0} && dot(to_first, to_second) <= 0;
    });
}

inline mesh::Contact contact(const std::vector<Vec3>& vertices, const mesh::Triangle& first,
                             const mesh::Triangle& second) {
    Polygon p;
    Polygon q;
    Polygon shared;
    for (int i = 0; i < 3; ++i) {
        p.push_back(exact_point(vertices[first[i]]));
        q.push_back(exact_point(vertices[second[i]]));
        if (std::count(second.begin(), second.end(), first[i]) > 0) {
            shared.push_back(p.back());
        }
    }
    for (const Polygon* t : {&p, &q}) {
        if (cross(minus((*t)[1], (*t)[0]), minus((*t)[2], (*t)[0])) == Vector{0, 0, 0}) {
            return mesh::Contact::None;
        }
    }
    const Polygon common = intersection(p, q);
    if (common.empty()) {
        return mesh::Contact::None;
    }
    Vector middle{0, 0, 0};
    for (const Vector& x : common) {
        for (int i = 0; i < 3; ++i) {
            middle[i] += x[i] / static_cast<int>(common.size());
        }
    }
    if (inside(middle, p) && inside(middle, q)) {
        return mesh::Contact::Crossing;
    }
    return within(common, shared) ? mesh::Contact::None : mesh::Contact::Touching;
}

}  // namespace mq::exact
