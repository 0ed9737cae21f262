// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/exact/exact_constrained_triangulation.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "base/angle.h"
#include "base/error.h"

namespace mq::boolean {

namespace {

[[noreturn]] void inconsistent(const char* what) {
    throw TopologyError(std::string("the division of a plane is inconsistent: ") + what);
}

}  // namespace

int ExactConstrainedTriangulation::add_point(ExactPoint point) {
    points_.push_back(std::move(point));
    out_.push_back(-1);
    return static_cast<int>(points_.size()) - 1;
}

int ExactConstrainedTriangulation::add_line(const Line& line) {
    lines_.push_back(line);
    return static_cast<int>(lines_.size()) - 1;
}

void ExactConstrainedTriangulation::start(int a, int b, int c) {
    new_triangle(a, b, c);
}

void ExactConstrainedTriangulation::link(int h, int other) {
    twin_[static_cast<std::size_t>(h)] = other;
    if (other >= 0) {
        twin_[static_cast<std::size_t>(other)] = h;
    }
}

void ExactConstrainedTriangulation::set_line(int h, int value) {
    line_[static_cast<std::size_t>(h)] = value;
    if (twin(h) >= 0) {
        line_[static_cast<std::size_t>(twin(h))] = value;
    }
}

void ExactConstrainedTriangulation::set_triangle(int t, int a, int b, int c) {
    const int corners[3] = {a, b, c};
    for (int k = 0; k < 3; ++k) {
        corner_[static_cast<std::size_t>(3 * t + k)] = corners[k];
        out_[static_cast<std::size_t>(corners[k])] = 3 * t + k;
    }
}

int ExactConstrainedTriangulation::new_triangle(int a, int b, int c) {
    const auto t = static_cast<int>(corner_.size() / 3);
    corner_.resize(corner_.size() + 3);
    twin_.resize(corner_.size(), -1);
    line_.resize(corner_.size(), -1);
    set_triangle(t, a, b, c);
    return t;
}

int ExactConstrainedTriangulation::orient(int a, int b, int c) const {
    return turn_ * orient2d(points_[static_cast<std::size_t>(a)], points_[static_cast<std::size_t>(b)],
                            points_[static_cast<std::size_t>(c)], axis_);
}

template <typename Visit>
void ExactConstrainedTriangulation::around(int vertex, Visit&& visit) const {
    const int first = out_[static_cast<std::size_t>(vertex)];
    int h = first;
    do {  // counter-clockwise
        if (visit(h)) {
            return;
        }
        h = twin(prev(h));
    } while (h >= 0 && h != first);
    if (h >= 0) {
        return;
    }
    for (h = twin(first); h >= 0; h = twin(h)) {  // the rest, when the vertex is on the border
        h = next(h);
        if (visit(h)) {
            return;
        }
    }
}

int ExactConstrainedTriangulation::find(int a, int b) const {
    int found = -1;
    around(a, [&](int h) {
        found = target(h) == b ? h : -1;
        return found >= 0;
    });
    return found;
}

void ExactConstrainedTriangulation::split(int h, int point) {
    const int other = twin(h);
    const int at = line(h);
    const int a = origin(h);
    const int b = target(h);
    const int c = apex(h);
    const int outer_bc = twin(next(h));
    const int line_bc = line(next(h));
    const int t = h / 3;
    const int line_ca = line(prev(h));
    const int outer_ca = twin(prev(h));
    const int u = new_triangle(point, b, c);
    set_triangle(t, a, point, c);
    const auto give = [&](int half, int outer, int value) {
        link(half, outer);
        line_[static_cast<std::size_t>(half)] = value;
    };
    give(3 * u + 1, outer_bc, line_bc);
    give(3 * t + 2, outer_ca, line_ca);
    link(3 * t + 1, 3 * u + 2);
    line_[static_cast<std::size_t>(3 * t + 1)] = -1;
    line_[static_cast<std::size_t>(3 * u + 2)] = -1;
    give(3 * t, -1, at);
    give(3 * u, -1, at);
    if (other < 0) {
        return;
    }
    const int d = apex(other);
    const int outer_ad = twin(next(other));
    const int line_ad = line(next(other));
    const int outer_db = twin(prev(other));
    const int line_db = line(prev(other));
    const int s = other / 3;
    const int r = new_triangle(point, a, d);
    set_triangle(s, b, point, d);
    give(3 * r + 1, outer_ad, line_ad);
    give(3 * s + 2, outer_db, line_db);
    link(3 * s + 1, 3 * r + 2);
    line_[static_cast<std::size_t>(3 * s + 1)] = -1;
    line_[static_cast<std::size_t>(3 * r + 2)] = -1;
    line_[static_cast<std::size_t>(3 * s)] = at;
    line_[static_cast<std::size_t>(3 * r)] = at;
    link(3 * t, 3 * r);
    link(3 * u, 3 * s);
}

void ExactConstrainedTriangulation::split_triangle(int t, int point) {
    const int corner[3] = {origin(3 * t), origin(3 * t + 1), origin(3 * t + 2)};
    const int outer[3] = {twin(3 * t), twin(3 * t + 1), twin(3 * t + 2)};
    const int lines[3] = {line(3 * t), line(3 * t + 1), line(3 * t + 2)};
    const int piece[3] = {t, new_triangle(corner[1], corner[2], point), new_triangle(corner[2], corner[0], point)};
    set_triangle(t, corner[0], corner[1], point);
    for (int k = 0; k < 3; ++k) {
        link(3 * piece[k], outer[k]);
        line_[static_cast<std::size_t>(3 * piece[k])] = lines[k];
        link(3 * piece[k] + 1, 3 * piece[(k + 1) % 3] + 2);
        line_[static_cast<std::size_t>(3 * piece[k] + 1)] = -1;
        line_[static_cast<std::size_t>(3 * piece[k] + 2)] = -1;
    }
}

void ExactConstrainedTriangulation::split_edge(int a, int b, int point) {
    int h = find(a, b);
    if (h < 0) {
        h = find(b, a);
    }
    if (h < 0) {
        inconsistent("an edge to be divided is missing");
    }
    split(h, point);
}

int ExactConstrainedTriangulation::insert(int point) {
    check_cancelled(progress_);
    const int placed = place(point);
    if (placed == point) {
        improve_around(point);
    }
    return placed;
}

/// Divides the triangle or the edge that contains the point. Returns the point, or the point that was in its place
/// before.
int ExactConstrainedTriangulation::place(int point) {
    const auto triangles = static_cast<int>(corner_.size() / 3);
    int t = triangles - 1;
    // A walk towards the point; it may cycle in a triangulation that is not Delaunay, hence the scan afterwards.
    for (int steps = 0; steps < 2 * triangles; ++steps) {
        int sides[3];
        int out = -1;
        for (int k = 0; k < 3; ++k) {
            sides[k] = orient(origin(3 * t + k), target(3 * t + k), point);
            if (sides[k] < 0 && twin(3 * t + k) >= 0) {
                out = 3 * t + k;
            }
        }
        if (sides[0] >= 0 && sides[1] >= 0 && sides[2] >= 0) {
            const int zeros = (sides[0] == 0) + (sides[1] == 0) + (sides[2] == 0);
            if (zeros == 0) {
                split_triangle(t, point);
            } else if (zeros == 1) {
                split(3 * t + (sides[0] == 0 ? 0 : (sides[1] == 0 ? 1 : 2)), point);
            } else {
                return origin(3 * t + (sides[0] != 0 ? 2 : (sides[1] != 0 ? 0 : 1)));
            }
            return point;
        }
        t = steps < triangles && out >= 0 ? twin(out) / 3 : (t + 1) % triangles;
    }
    inconsistent("a point lies outside");
}

bool ExactConstrainedTriangulation::in_triangle(int point, int a, int b, int c) const {
    return orient(a, b, point) >= 0 && orient(b, c, point) >= 0 && orient(c, a, point) >= 0;
}

/// Whether c, on the line from a through b, lies on b's side of a.
bool ExactConstrainedTriangulation::ahead(int a, int b, int c) const {
    for (int k = 1; k <= 2; ++k) {
        const int axis = (axis_ + k) % 3;
        const int way = compare(points_[static_cast<std::size_t>(b)], points_[static_cast<std::size_t>(a)], axis);
        if (way != 0) {
            return way == compare(points_[static_cast<std::size_t>(c)], points_[static_cast<std::size_t>(a)], axis);
        }
    }
    return false;
}

/// On which side of the segment's line a point lies. The points that the segment has passed need no computation: for
/// constructed ones their zero would be the most expensive sign of all.
int ExactConstrainedTriangulation::side(const Segment& segment, int point) const {
    const bool passed = point == segment.from || point == segment.to || point == segment.at || point == segment.before;
    return passed ? 0 : orient(segment.from, segment.to, point);
}

ExactConstrainedTriangulation::Crossing ExactConstrainedTriangulation::leave(const Segment& segment) const {
    const int a = segment.at;
    const int b = segment.to;
    if (find(a, b) >= 0 || find(b, a) >= 0) {
        return {-1, b};
    }
    Crossing found;
    around(a, [&](int h) {
        const int x = target(h);
        const int y = apex(h);
        const int side_x = side(segment, x);
        const int side_y = side(segment, y);
        if (side_x == 0 && x != segment.before && ahead(a, b, x)) {
            found.vertex = x;
        } else if (side_y == 0 && y != segment.before && ahead(a, b, y)) {
            found.vertex = y;
        } else if (side_x < 0 && side_y > 0) {
            found.half_edge = next(h);
        }
        return found.vertex >= 0 || found.half_edge >= 0;
    });
    return found;
}

bool ExactConstrainedTriangulation::flippable(int h) const {
    const int g = twin(h);
    return orient(apex(g), target(h), apex(h)) > 0 && orient(apex(h), origin(h), apex(g)) > 0;
}

void ExactConstrainedTriangulation::flip(int h) {
    const int g = twin(h);
    const int a = origin(h);
    const int b = target(h);
    const int c = apex(h);
    const int d = apex(g);
    const int bc = twin(next(h));
    const int ca = twin(prev(h));
    const int ad = twin(next(g));
    const int db = twin(prev(g));
    const int line_bc = line(next(h));
    const int line_ca = line(prev(h));
    const int line_ad = line(next(g));
    const int line_db = line(prev(g));
    const int t = h / 3;
    const int s = g / 3;
    set_triangle(t, d, b, c);
    set_triangle(s, c, a, d);
    const int halves[6] = {3 * t, 3 * t + 1, 3 * t + 2, 3 * s, 3 * s + 1, 3 * s + 2};
    const int outer[6] = {db, bc, -1, ca, ad, -1};
    const int lines[6] = {line_db, line_bc, -1, line_ca, line_ad, -1};
    for (int i = 0; i < 6; ++i) {
        link(halves[i], outer[i]);
        line_[static_cast<std::size_t>(halves[i])] = lines[i];
    }
    link(3 * t + 2, 3 * s + 2);
}

/// Makes the piece of the segment up to `end` an edge: swaps away the edges that cross it (Sloan 1993), none of them a
/// constraint.
void ExactConstrainedTriangulation::clear_way(const Segment& segment, int end,
                                              const std::vector<std::array<int, 2>>& crossed) {
    std::deque<std::array<int, 2>> todo(crossed.begin(), crossed.end());
    const std::size_t most = 64 + 16 * todo.size() * todo.size();
    for (std::size_t steps = 0; !todo.empty(); ++steps) {
        check_cancelled(progress_);
        if (steps > most) {
            inconsistent("a segment cannot be cleared");
        }
        const auto [u, v] = todo.front();
        todo.pop_front();
        const int h = find(u, v);
        if (!flippable(h)) {
            todo.push_back({u, v});
            continue;
        }
        const int p = apex(h);
        const int q = apex(twin(h));
        flip(h);
        const bool touches = p == segment.at || p == end || q == segment.at || q == end;
        if (!touches && side(segment, p) * side(segment, q) < 0) {
            todo.push_back({p, q});
        }
    }
}

/// Divides the constraint h where a segment of `line` crosses it.
int ExactConstrainedTriangulation::split_at_crossing(int h, int at) {
    const Line& one = lines_[static_cast<std::size_t>(line(h))];
    const Line& two = lines_[static_cast<std::size_t>(at)];
    ExactPoint point =
        one.edge ? ExactPoint::on_line(one.from, one.to, two.edge ? standing_plane(two.from, two.to, axis_) : two.plane)
        : two.edge ? ExactPoint::on_line(two.from, two.to, one.plane)
                   : ExactPoint::on_planes(plane_, one.plane, two.plane);
    const int added = add_point(std::move(point));
    split(h, added);
    return added;
}

/// Inserts one piece of the segment, up to the next point on it. Returns that point.
int ExactConstrainedTriangulation::step(const Segment& segment) {
    check_cancelled(progress_);
    const Crossing first = leave(segment);
    int end = first.vertex;
    std::vector<std::array<int, 2>> crossed;
    for (int h = first.half_edge; end < 0;) {
        if (h < 0) {
            inconsistent("a segment leaves the plane's part");
        }
        if (line(h) >= 0) {
            end = split_at_crossing(h, segment.line);
            break;
        }
        crossed.push_back({origin(h), target(h)});
        h = twin(h);
        if (h < 0) {
            inconsistent("a segment leaves the plane's part");
        }
        const int v = apex(h);
        const int beside = side(segment, v);
        if (beside == 0) {
            end = v;
        } else {
            // The walk goes on through the edge with one end on either side; h runs from its left to its right.
            h = beside > 0 ? next(h) : prev(h);
        }
    }
    clear_way(segment, end, crossed);
    int h = find(segment.at, end);
    if (h < 0) {
        h = find(end, segment.at);
    }
    if (h < 0) {
        inconsistent("a segment is missing");
    }
    set_line(h, segment.line);
    return end;
}

void ExactConstrainedTriangulation::constrain(int a, int b, int at) {
    Segment segment{a, b, at, -1, a};
    while (segment.at != b) {
        const int end = step(segment);
        segment.before = segment.at;
        segment.at = end;
    }
}

bool ExactConstrainedTriangulation::better_flipped(int h) const {
    const auto at = [&](int p) -> const Vec3& { return points_[static_cast<std::size_t>(p)].approx(); };
    const Vec3& a = at(origin(h));
    const Vec3& b = at(target(h));
    const Vec3& c = at(apex(h));
    const Vec3& d = at(apex(twin(h)));
    // Least factor by which a swap enlarges it: above the rounding, so that swaps end.
    constexpr double kClearly = 1.0 + 1e-6;
    return std::min(squared_sine_of_smallest_angle(d, b, c), squared_sine_of_smallest_angle(c, a, d)) >
           kClearly * std::min(squared_sine_of_smallest_angle(a, b, c), squared_sine_of_smallest_angle(b, a, d));
}

/// Swaps the edges opposite to the point, and the new edges opposite to it, as long as that enlarges angles (Lawson
/// 1977).
void ExactConstrainedTriangulation::improve_around(int point) {
    std::vector<int> opposite;
    around(point, [&](int h) {
        opposite.push_back(next(h));
        return false;
    });
    while (!opposite.empty()) {
        const int h = opposite.back();
        opposite.pop_back();
        if (apex(h) != point || twin(h) < 0 || line(h) >= 0 || !better_flipped(h) || !flippable(h)) {
            continue;
        }
        const int t = h / 3;
        const int other = twin(h) / 3;
        flip(h);
        opposite.insert(opposite.end(), {3 * t, 3 * other + 1});  // see flip() for the corners' order
    }
}

void ExactConstrainedTriangulation::improve() {
    // Rounds of swaps at most, so that they end.
    constexpr int kPasses = 8;
    bool changed = true;
    for (int pass = 0; pass < kPasses && changed; ++pass) {
        changed = false;
        for (int h = 0; h < static_cast<int>(corner_.size()); ++h) {
            check_cancelled(progress_);
            if (twin(h) > h && line(h) < 0 && better_flipped(h) && flippable(h)) {
                flip(h);
                changed = true;
            }
        }
    }
}

std::vector<std::array<int, 3>> ExactConstrainedTriangulation::triangles() const {
    std::vector<std::array<int, 3>> result;
    for (int h = 0; h < static_cast<int>(corner_.size()); h += 3) {
        result.push_back({origin(h), origin(h + 1), origin(h + 2)});
    }
    return result;
}

}  // namespace mq::boolean
