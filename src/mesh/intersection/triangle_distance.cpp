// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/predicates.h"

namespace mq::mesh {

Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double d1 = ab.dot(p - a);
    const double d2 = ac.dot(p - a);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return a;
    }
    const double d3 = ab.dot(p - b);
    const double d4 = ac.dot(p - b);
    if (d3 >= 0.0 && d4 <= d3) {
        return b;
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        return a + d1 / (d1 - d3) * ab;
    }
    const double d5 = ab.dot(p - c);
    const double d6 = ac.dot(p - c);
    if (d6 >= 0.0 && d5 <= d6) {
        return c;
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        return a + d2 / (d2 - d6) * ac;
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    }
    return a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac;
}

namespace {

/// Keeps the nearer pair of points.
void keep_nearest(const Vec3& on_first, const Vec3& on_second, TriangleDistance& nearest) {
    const double distance = (on_first - on_second).norm();
    if (distance < nearest.distance) {
        nearest.distance = distance;
        nearest.on_first = on_first;
        nearest.on_second = on_second;
    }
}

/// The depth to which the segment from p to q goes through the triangle; negative: it does not. Segments in its plane
/// are left to the distances of edges.
double depth_of(const Vec3& p, const Vec3& q, const Corners& t) {
    const int side_p = orient3d(t[0], t[1], t[2], p);
    const int side_q = orient3d(t[0], t[1], t[2], q);
    if (side_p * side_q > 0 || (side_p == 0 && side_q == 0)) {
        return -1.0;
    }
    const int first = orient3d(p, q, t[0], t[1]);
    const int second = orient3d(p, q, t[1], t[2]);
    const int third = orient3d(p, q, t[2], t[0]);
    if (std::min({first, second, third}) < 0 && std::max({first, second, third}) > 0) {
        return -1.0;
    }
    if (first == 0 || second == 0 || third == 0) {
        return 0.0;  // through an edge or a corner, which happens to bodies that only touch as well
    }
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    return std::min(std::abs(normal.dot(p - t[0])), std::abs(normal.dot(q - t[0])));
}

void include_crossing(const Corners& edges, const Corners& other, TriangleDistance& found) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& p = edges[i];
        const Vec3& q = edges[(i + 1) % 3];
        const double depth = depth_of(p, q, other);
        if (depth < 0.0) {
            continue;
        }
        found.depth = std::max(found.depth, depth);
        if (found.distance > 0.0) {
            const Vec3 normal = (other[1] - other[0]).cross(other[2] - other[0]);
            const double speed = normal.dot(q - p);
            const double at = speed != 0.0 ? std::clamp(normal.dot(other[0] - p) / speed, 0.0, 1.0) : 0.0;
            found.distance = 0.0;
            found.on_first = found.on_second = p + at * (q - p);
        }
    }
}

}  // namespace

std::array<Vec3, 2> nearest_of_segments(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    const Vec3 d1 = q - p;
    const Vec3 d2 = s - r;
    const Vec3 between = p - r;
    const double a = d1.squaredNorm();
    const double e = d2.squaredNorm();
    const double b = d1.dot(d2);
    const double c = d1.dot(between);
    const double f = d2.dot(between);
    const double determinant = a * e - b * b;
    double x = determinant > 0.0 ? std::clamp((b * f - c * e) / determinant, 0.0, 1.0) : 0.0;
    double y = e > 0.0 ? (b * x + f) / e : 0.0;
    if (y < 0.0 || y > 1.0) {
        y = std::clamp(y, 0.0, 1.0);
        x = a > 0.0 ? std::clamp((b * y - c) / a, 0.0, 1.0) : 0.0;
    }
    return {p + x * d1, r + y * d2};
}

TriangleDistance triangle_distance(const Corners& first, const Corners& second) {
    TriangleDistance found;
    found.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        keep_nearest(first[i], nearest_on_triangle(first[i], second[0], second[1], second[2]), found);
        keep_nearest(nearest_on_triangle(second[i], first[0], first[1], first[2]), second[i], found);
        for (std::size_t j = 0; j < 3; ++j) {
            const auto [p, q] = nearest_of_segments(first[i], first[(i + 1) % 3], second[j], second[(j + 1) % 3]);
            keep_nearest(p, q, found);
        }
    }
    include_crossing(first, second, found);
    include_crossing(second, first, found);
    return found;
}

}  // namespace mq::mesh
