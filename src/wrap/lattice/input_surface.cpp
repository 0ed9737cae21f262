// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/lattice/input_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/predicates.h"

namespace mq::wrap {

namespace {

using mesh::Triangle;

const Vec3& point(const InputSurface& surface, const Triangle& t, int k) {
    return surface.points[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
}

/// @param side  the side of the triangle on which the segment begins
bool meets_triangle(const InputSurface& surface, const Triangle& t, const Vec3& p, const Vec3& q, int side) {
    const Vec3& a = point(surface, t, 0);
    const Vec3& b = point(surface, t, 1);
    const Vec3& c = point(surface, t, 2);
    if (side != 0 && side == orient3d(a, b, c, q)) {
        return false;
    }
    const int ab = orient3d(p, q, a, b);
    const int bc = orient3d(p, q, b, c);
    const int ca = orient3d(p, q, c, a);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

int side_of(const InputSurface& surface, const Triangle& t, const Vec3& p) {
    return orient3d(point(surface, t, 0), point(surface, t, 1), point(surface, t, 2), p);
}

bool meets_triangle(const InputSurface& surface, const Triangle& t, const Vec3& p, const Vec3& q) {
    return meets_triangle(surface, t, p, q, side_of(surface, t, p));
}

}  // namespace

unsigned InputSurface::met_of(const Fan& fan) const {
    Box all;
    all.add(fan.from);
    std::array<Box, Fan::kMostSegments> boxes;
    for (std::size_t k = 0; k < fan.count; ++k) {
        all.add(fan.to[k]);
        boxes[k].add(fan.from);
        boxes[k].add(fan.to[k]);
    }
    const unsigned whole = (1U << fan.count) - 1U;
    unsigned met = 0;
    tree.for_each_in_box(all, [&](std::int32_t t) {
        const Triangle& corners = triangles[static_cast<std::size_t>(t)];
        Box box;
        for (int k = 0; k < 3; ++k) {
            box.add(point(*this, corners, k));
        }
        const int side = side_of(*this, corners, fan.from);
        for (std::size_t k = 0; k < fan.count; ++k) {
            if ((met >> k & 1U) == 0 && boxes[k].meets(box) &&
                meets_triangle(*this, corners, fan.from, fan.to[k], side)) {
                met |= 1U << k;
            }
        }
        return met != whole;
    });
    return met;
}

bool InputSurface::meets(const Vec3& from, const Vec3& to) const {
    return met_of({from, {to}, 1}) != 0;
}

FirstMeeting InputSurface::first_meeting(const Vec3& from, const Vec3& to) const {
    FirstMeeting first;
    Box box;
    box.add(from);
    box.add(to);
    tree.for_each_in_box(box, [&](std::int32_t t) {
        const Triangle& corners = triangles[static_cast<std::size_t>(t)];
        if (!meets_triangle(*this, corners, from, to)) {
            return;
        }
        const Vec3& a = point(*this, corners, 0);
        const Vec3 cross = (point(*this, corners, 1) - a).cross(point(*this, corners, 2) - a);
        const double ahead = cross.dot(to - from);
        // The segment lies in the triangle's plane, so that it meets the triangle in no single point; the middle is
        // returned.
        const double share = ahead != 0.0 ? std::clamp(cross.dot(a - from) / ahead, 0.0, 1.0) : 0.5;
        if (share < first.share || (share == first.share && t < first.triangle)) {
            first = {share, t};
        }
    });
    return first;
}

Vec3 InputSurface::normal(std::int32_t triangle) const {
    const Triangle& t = triangles[static_cast<std::size_t>(triangle)];
    const Vec3 cross = (point(*this, t, 1) - point(*this, t, 0)).cross(point(*this, t, 2) - point(*this, t, 0));
    const double length = cross.norm();
    return length > 0.0 ? Vec3(cross / length) : Vec3(Vec3::Zero());
}

}  // namespace mq::wrap
