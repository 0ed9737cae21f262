// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/embedded_star.h"

#include <array>
#include <limits>

namespace mq::mesh {
namespace {

constexpr std::size_t kLargestStar = 24;  ///< larger ones are tested pair by pair

/// The edge of a triangle opposite the vertex.
struct LinkEdge {
    std::int32_t tail;
    std::int32_t head;
};

/// Every vertex is as often a head as a tail, so that the link is made of closed walks.
bool is_closed(const LinkEdge* link, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        int balance = 0;
        for (std::size_t j = 0; j < count; ++j) {
            balance += (link[j].tail == link[i].head) - (link[j].head == link[i].head);
        }
        if (balance != 0) {
            return false;
        }
    }
    return true;
}

/// Two directions that span the plane across `normal`, roughly as long as it and turning counter-clockwise around it.
void span_plane(const Vec3& normal, Vec3& x, Vec3& y) {
    int axis = 0;
    normal.cwiseAbs().minCoeff(&axis);
    x = normal.cross(Vec3::Unit(axis));
    y = normal.cross(x);
}

}  // namespace

// The projection (q . x, q . y) of q = p - v is a linear map with exactly the coefficients x and y, whatever their
// rounding errors. A computed coordinate has an error of less than 5 u |q| |x|, the turn of two of them, x1 y2 - x2 y1,
// of less than 24 u |q1| |q2| |x| |y|, with u the unit roundoff. A turn above the margin of 64 u is then positive for
// the true projections, for the computed ones, and for all those between them: both polygons turn equally often around
// v. As every step turns by less than half a turn, the number of turns is the number of times that the sign of y
// changes from - to +.
bool embedded_star(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles, VertexStars::Star star) {
    const std::size_t count = star.size();
    if (count < 3 || count > kLargestStar) {
        return false;
    }
    std::array<LinkEdge, kLargestStar> link;
    std::array<Vec3, kLargestStar> tail;
    std::array<Vec3, kLargestStar> head;
    Vec3 normal = Vec3::Zero();
    const Vec3 center = vertices[triangles[*star.first / 3][*star.first % 3]];
    for (std::size_t k = 0; k < count; ++k) {
        const Triangle& t = triangles[star.first[k] / 3];
        const std::uint32_t i = star.first[k] % 3;
        link[k] = {t[(i + 1) % 3], t[(i + 2) % 3]};
        tail[k] = vertices[link[k].tail] - center;
        head[k] = vertices[link[k].head] - center;
        const Vec3 cross = tail[k].cross(head[k]);
        const double length = cross.norm();
        if (length == 0.0) {
            return false;
        }
        normal += cross / length;
    }
    if (!is_closed(link.data(), count)) {
        return false;
    }
    Vec3 x;
    Vec3 y;
    span_plane(normal, x, y);
    // 64 unit roundoffs, see above; epsilon is two of them.
    constexpr double kMargin = 32.0 * std::numeric_limits<double>::epsilon();
    const double margin = kMargin * kMargin * x.squaredNorm() * y.squaredNorm();
    int turns = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double y_tail = tail[k].dot(y);
        const double y_head = head[k].dot(y);
        const double turn = tail[k].dot(x) * y_head - head[k].dot(x) * y_tail;
        if (turn <= 0.0 || !(turn * turn > margin * tail[k].squaredNorm() * head[k].squaredNorm())) {
            return false;
        }
        turns += static_cast<int>(y_tail < 0.0 && y_head >= 0.0);
    }
    return turns == 1;
}

}  // namespace mq::mesh
