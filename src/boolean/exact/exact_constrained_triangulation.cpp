// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/exact/exact_constrained_triangulation.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::boolean {

namespace {

[[noreturn]] void inconsistent() {
    throw TopologyError(phrases::kInconsistentDivision);
}

}  // namespace

int PointsOfPlane::orient(int a, int b, int c) const {
    return turn * orient2d(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)],
                           points[static_cast<std::size_t>(c)], axis);
}

bool PointsOfPlane::ahead(int a, int b, int c) const {
    for (int k = 1; k <= 2; ++k) {
        const int along = (axis + k) % 3;
        const ExactPoint& from = points[static_cast<std::size_t>(a)];
        const int way = compare(points[static_cast<std::size_t>(b)], from, along);
        if (way != 0) {
            return way == compare(points[static_cast<std::size_t>(c)], from, along);
        }
    }
    return false;
}

void PointsOfPlane::outside() {
    inconsistent();
}

int ExactConstrainedTriangulation::add_line(const Line& line) {
    lines_.push_back(line);
    return static_cast<int>(lines_.size()) - 1;
}

void ExactConstrainedTriangulation::split_edge(int a, int b, int point) {
    const int h = edge_between(a, b);
    if (h < 0) {
        inconsistent();
    }
    ConstrainedTriangulation::split_edge(h, point);
}

int ExactConstrainedTriangulation::insert(int point) {
    check_cancelled(progress_);
    const Place place = locate(triangle_count() - 1, point);
    if (place.vertex >= 0) {
        return place.vertex;
    }
    split(place, point);
    flip_suspects([&](int h) { return apex(h) == point && better_flipped(h) && flippable(h); });
    return point;
}

bool ExactConstrainedTriangulation::in_triangle(int point, int a, int b, int c) const {
    return points_.orient(a, b, point) >= 0 && points_.orient(b, c, point) >= 0 && points_.orient(c, a, point) >= 0;
}

/// Divides the constraint h where a segment of `line` crosses it.
int ExactConstrainedTriangulation::split_at_crossing(int h, int at) {
    const Line& one = lines_[static_cast<std::size_t>(label(h))];
    const Line& two = lines_[static_cast<std::size_t>(at)];
    ExactPoint point = one.edge
                           ? ExactPoint::on_line(one.from, one.to,
                                                 two.edge ? standing_plane(two.from, two.to, points_.axis) : two.plane)
                       : two.edge ? ExactPoint::on_line(two.from, two.to, one.plane)
                                  : ExactPoint::on_planes(plane_, one.plane, two.plane);
    const int added = add_vertex(std::move(point));
    ConstrainedTriangulation::split_edge(h, added);
    return added;
}

void ExactConstrainedTriangulation::constrain(int a, int b, int line) {
    for (Segment segment{a, b, -1, a}; segment.at != b;) {
        check_cancelled(progress_);
        Edges crossed;
        const Stop stop = walk(segment, crossed);
        const int end = stop.constraint >= 0 ? split_at_crossing(stop.constraint, line) : stop.vertex;
        if (end < 0) {
            inconsistent();
        }
        clear_way(segment, end, crossed);
        const int h = edge_between(segment.at, end);
        if (h < 0) {
            inconsistent();
        }
        set_label(h, line);
        segment.before = segment.at;
        segment.at = end;
    }
}

bool ExactConstrainedTriangulation::better_flipped(int h) const {
    const auto at = [&](int p) -> const Vec3& { return points()[static_cast<std::size_t>(p)].approx(); };
    const Vec3& a = at(corner(h));
    const Vec3& b = at(target(h));
    const Vec3& c = at(apex(h));
    const Vec3& d = at(apex(twin(h)));
    // Least factor by which a swap enlarges it: above the rounding, so that swaps end.
    constexpr double kClearly = 1.0 + 1e-6;
    return std::min(squared_sine_of_smallest_angle(d, b, c), squared_sine_of_smallest_angle(c, a, d)) >
           kClearly * std::min(squared_sine_of_smallest_angle(a, b, c), squared_sine_of_smallest_angle(b, a, d));
}

void ExactConstrainedTriangulation::improve() {
    // Rounds of swaps at most, so that they end.
    constexpr int kPasses = 8;
    bool changed = true;
    for (int pass = 0; pass < kPasses && changed; ++pass) {
        changed = false;
        for (int h = 0; h < 3 * triangle_count(); ++h) {
            check_cancelled(progress_);
            if (twin(h) > h && label(h) < 0 && better_flipped(h) && flippable(h)) {
                flip(h);
                changed = true;
            }
        }
    }
}

std::vector<std::array<int, 3>> ExactConstrainedTriangulation::triangles() const {
    std::vector<std::array<int, 3>> result;
    for (int h = 0; h < 3 * triangle_count(); h += 3) {
        result.push_back({corner(h), corner(h + 1), corner(h + 2)});
    }
    return result;
}

}  // namespace mq::boolean
