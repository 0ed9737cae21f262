// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/uv_outline.h"

#include <algorithm>

#include "base/predicates.h"

namespace mq::triangulate {

std::vector<Segment2> outline_of(const FaceBoundary& border) {
    std::vector<Segment2> outline;
    for (const FaceBoundary::Piece& piece : border.pieces) {
        if (!piece.internal) {
            outline.push_back({border.sites[piece.from].uv, border.sites[piece.to].uv});
        }
    }
    return outline;
}

bool meets(const Triangle2& triangle, const Segment2& segment) {
    const auto& [a, b, c] = triangle;
    const int turn = orient2d(a, b, c);
    // Tests for a separating line through a side or the segment; boxes first, since most are far from each other.
    for (int axis = 0; axis < 2; ++axis) {
        const auto [low, high] = std::minmax({a[axis], b[axis], c[axis]});
        const auto [from, to] = std::minmax(segment[0][axis], segment[1][axis]);
        if (to < low || from > high) {
            return false;
        }
    }
    for (int i = 0; i < 3; ++i) {
        const Vec2& p = triangle[i];
        const Vec2& q = triangle[(i + 1) % 3];
        if (turn * orient2d(p, q, segment[0]) < 0 && turn * orient2d(p, q, segment[1]) < 0) {
            return false;
        }
    }
    const int sides[3] = {orient2d(segment[0], segment[1], a), orient2d(segment[0], segment[1], b),
                          orient2d(segment[0], segment[1], c)};
    const auto [least, most] = std::minmax_element(sides, sides + 3);
    return *least <= 0 && *most >= 0;
}

bool crosses(const Vec2& p, const Vec2& q, const Segment2& segment) {
    return (orient2d(p, q, segment[0]) >= 0) != (orient2d(p, q, segment[1]) >= 0) &&
           (orient2d(segment[0], segment[1], p) >= 0) != (orient2d(segment[0], segment[1], q) >= 0);
}

}  // namespace mq::triangulate
