// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/straight_piercing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/segment_distance.h"

namespace mq::curve {

namespace {

double distance_of_segments(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q) {
    const Vec3 u = b - a;
    const Vec3 v = q - p;
    const Vec3 n = u.cross(v);
    const double square = n.squaredNorm();
    const double s = (p - a).cross(v).dot(n);
    const double t = (p - a).cross(u).dot(n);
    if (square > 0.0 && s >= 0.0 && s <= square && t >= 0.0 && t <= square) {
        return std::abs((p - a).dot(n)) / std::sqrt(square);
    }
    return std::min({distance_to_segment(a, p, q), distance_to_segment(b, p, q), distance_to_segment(p, a, b),
                     distance_to_segment(q, a, b)});
}

}  // namespace

std::optional<Vec3> certain_piercing(const Vec3& p, const Vec3& q, double curve_bend,
                                     const std::array<Vec3, 3>& triangle, double disc_bend) {
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
    const double from = normal.dot(p - triangle[0]);
    const double to = normal.dot(q - triangle[0]);
    if (!(from * to < 0.0) || !(std::abs(from) > disc_bend) || !(std::abs(to) > disc_bend)) {
        return std::nullopt;
    }
    const Vec3 point = p + from / (from - to) * (q - p);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = triangle[k];
        const Vec3& b = triangle[(k + 1) % 3];
        const bool inside = (b - a).cross(point - a).dot(normal) > 0.0;
        if (!inside || !(distance_of_segments(a, b, p, q) > curve_bend + disc_bend)) {
            return std::nullopt;
        }
    }
    return point;
}

}  // namespace mq::curve
