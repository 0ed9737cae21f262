// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/embedded_star.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace mq::mesh {
namespace {

/// Whether every vertex is as often a head as a tail, so that the link consists of closed walks. `tails` and `heads`
/// are buffers for `count` vertices each.
bool is_closed(const StarSector* sectors, std::size_t count, std::int32_t* tails, std::int32_t* heads) {
    for (std::size_t i = 0; i < count; ++i) {
        tails[i] = sectors[i].from;
        heads[i] = sectors[i].to;
    }
    std::sort(tails, tails + count);
    std::sort(heads, heads + count);
    return std::equal(tails, tails + count, heads);
}

/// Two directions that span the plane across `normal`, roughly as long as it and turning counter-clockwise around it.
void span_plane(const Vec3& normal, Vec3& x, Vec3& y) {
    int axis = 0;
    normal.cwiseAbs().minCoeff(&axis);
    x = normal.cross(Vec3::Unit(axis));
    y = normal.cross(x);
}

// The projection (q . x, q . y) of q = p - v is a linear map with exactly the coefficients x and y, whatever their
// rounding errors. A computed coordinate has an error of less than 5 u |q| |x|, the turn of two of them, x1 y2 - x2 y1,
// of less than 24 u |q1| |q2| |x| |y|, with u the unit roundoff. A turn above the margin of 64 u is then positive for
// the true projections, for the computed ones, and for all those between them: both polygons turn equally often around
// v. As every step turns by less than half a turn, the number of turns is the number of times that the sign of y
// changes from - to +.
bool turns_once(const StarSector* sectors, std::size_t count, const Vec3& normal) {
    Vec3 x;
    Vec3 y;
    span_plane(normal, x, y);
    // 64 unit roundoffs, see above; epsilon is two of them.
    constexpr double kMargin = 32.0 * std::numeric_limits<double>::epsilon();
    const double margin = kMargin * kMargin * x.squaredNorm() * y.squaredNorm();
    int turns = 0;
    for (const StarSector* s = sectors; s != sectors + count; ++s) {
        const double y_tail = s->tail.dot(y);
        const double y_head = s->head.dot(y);
        const double turn = s->tail.dot(x) * y_head - s->head.dot(x) * y_tail;
        if (turn <= 0.0 || !(turn * turn > margin * s->tail.squaredNorm() * s->head.squaredNorm())) {
            return false;
        }
        turns += static_cast<int>(y_tail < 0.0 && y_head >= 0.0);
    }
    return turns == 1;
}

/// The buffers have space for as many vertices as there are triangles.
bool is_embedded(const StarSector* sectors, std::size_t count, std::int32_t* tails, std::int32_t* heads) {
    Vec3 normal = Vec3::Zero();
    for (const StarSector* s = sectors; s != sectors + count; ++s) {
        const Vec3 cross = s->tail.cross(s->head);
        const double length = cross.norm();
        if (length == 0.0) {
            return false;
        }
        normal += cross / length;
    }
    return is_closed(sectors, count, tails, heads) && turns_once(sectors, count, normal);
}

constexpr std::size_t kOnStack = 24;  // triangles of a star without allocation of memory

}  // namespace

bool embedded_star(const StarSector* sectors, std::size_t count) {
    if (count < 3) {
        return false;
    }
    if (count <= kOnStack) {
        std::array<std::int32_t, kOnStack> tails;
        std::array<std::int32_t, kOnStack> heads;
        return is_embedded(sectors, count, tails.data(), heads.data());
    }
    std::vector<std::int32_t> tails(count);
    std::vector<std::int32_t> heads(count);
    return is_embedded(sectors, count, tails.data(), heads.data());
}

bool embedded_star(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles, VertexStars::Star star) {
    if (star.size() < 3) {
        return false;
    }
    std::array<StarSector, kOnStack> on_stack;
    std::vector<StarSector> large(star.size() <= kOnStack ? 0 : star.size());
    StarSector* sectors = large.empty() ? on_stack.data() : large.data();
    const Vec3 center = vertices[triangles[*star.first / 3][*star.first % 3]];
    for (std::size_t k = 0; k < star.size(); ++k) {
        const Triangle& t = triangles[star.first[k] / 3];
        const std::uint32_t i = star.first[k] % 3;
        const std::int32_t from = t[(i + 1) % 3];
        const std::int32_t to = t[(i + 2) % 3];
        sectors[k] = {from, to, vertices[from] - center, vertices[to] - center};
    }
    return embedded_star(sectors, star.size());
}

}  // namespace mq::mesh
