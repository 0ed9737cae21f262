// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/progress.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/corner_table.h"

namespace mq::mesh {

struct NumberedTriangle {
    int number;
    std::array<int, 3> corners;
};

/// A triangulation of the plane in which given segments become edges, for points of any kind.
///
/// Half-edge h = 3 t + i runs from corner i to corner i + 1 of triangle t, counter-clockwise. A half-edge with a label
/// is a constraint. `Points` holds the points and gives
/// - `points`: a vector of them;
/// - `orient(a, b, c)`: the exact sign of the area of the triangle a, b, c;
/// - `ahead(a, b, c)`: whether c, on the line through a and b, lies on b's side of a;
/// - `outside()`: throws the error for a point outside of all triangles;
/// - the order in which triangles and half-edges are numbered and examined, which decides between equally good
///   triangulations: `flipped`, `divided`, `suspects` and `examined`.
template <typename Points>
class ConstrainedTriangulation {
  public:
    int triangle_count() const { return static_cast<int>(corner_.size() / 3); }
    int corner(int h) const { return corner_[static_cast<std::size_t>(h)]; }
    int twin(int h) const { return twin_[static_cast<std::size_t>(h)]; }    ///< -1 on the border
    int label(int h) const { return label_[static_cast<std::size_t>(h)]; }  ///< label of the constraint, or -1
    static int next(int h) { return next_corner(h); }
    static int prev(int h) { return previous_corner(h); }
    int target(int h) const { return corner(next(h)); }
    int apex(int h) const { return corner(prev(h)); }

    /// The half-edge from a to b, or -1.
    int find_edge(int a, int b) const {
        int found = -1;
        around(a, [&](int h) {
            found = target(h) == b ? h : -1;
            return found >= 0;
        });
        return found;
    }

  protected:
    /// Where a point lies.
    struct Place {
        int half_edge = -1;  ///< the point lies on it (on_edge) or in its triangle
        bool on_edge = false;
        int vertex = -1;  ///< the vertex in the point's place, or -1
    };
    /// A segment that becomes a chain of edges, and the vertex `at` that the chain has reached.
    struct Segment {
        int from = -1;
        int to = -1;
        int before = -1;  ///< the vertex before `at`; -1: there is none yet
        int at = -1;
    };
    /// The obstacle at which a segment's walk through triangles ends; neither: the segment leaves the triangulation.
    struct Stop {
        int vertex = -1;
        int constraint = -1;  ///< half-edge of a constraint that the segment crosses
    };
    using Edges = std::vector<std::array<int, 2>>;

    explicit ConstrainedTriangulation(Points points, const Progress* progress = nullptr)
        : points_(std::move(points)), progress_(progress) {}

    template <typename Point>
    int add_vertex(Point&& point) {
        points_.points.push_back(std::forward<Point>(point));
        out_.push_back(-1);
        return static_cast<int>(out_.size()) - 1;
    }

    /// The triangle must run counter-clockwise. Its edges have no twins.
    void add_triangle(int a, int b, int c) { retile(std::array<NumberedTriangle, 1>{{{grow(1), {a, b, c}}}}, {}); }

    void link(int h, int other) {
        twin_[static_cast<std::size_t>(h)] = other;
        if (other >= 0) {
            twin_[static_cast<std::size_t>(other)] = h;
        }
    }

    void set_label(int h, int value) {
        label_[static_cast<std::size_t>(h)] = value;
        if (twin(h) >= 0) {
            label_[static_cast<std::size_t>(twin(h))] = value;
        }
    }

    /// Visits the half-edges that leave a vertex, counter-clockwise, until `visit` returns true.
    template <typename Visit>
    void around(int vertex, Visit&& visit) const {
        const int first = out_[static_cast<std::size_t>(vertex)];
        int h = first;
        do {
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

    /// The half-edge between a and b, whichever way it runs.
    int edge_between(int a, int b) const {
        const int h = find_edge(a, b);
        return h >= 0 ? h : find_edge(b, a);
    }

    /// Walks to a point from triangle t. On a Delaunay triangulation a visibility walk cannot cycle; beside constraints
    /// and flipped edges it can. Drawing the edge that is asked first at random breaks all cycles (Devillers, Pion,
    /// Teillaud 2002).
    Place locate(int t, int point) const {
        constexpr int kInTurn = 1000;  // steps before edges are drawn at random
        std::minstd_rand lot;
        for (int step = 0;; ++step) {
            const auto turn = static_cast<unsigned>(step <= kInTurn ? step : lot());
            int out = -1;
            int on = -1;
            int off = -1;
            int touching = 0;
            for (unsigned k = 0; k < 3 && out < 0; ++k) {
                const int h = 3 * t + static_cast<int>(step <= kInTurn ? Points::examined(turn, k) : (turn + k) % 3);
                const int side = points_.orient(corner(h), target(h), point);
                (side < 0 ? out : side == 0 ? on : off) = h;
                touching += side == 0 ? 1 : 0;
            }
            if (out < 0) {
                return {touching > 0 ? on : 3 * t, touching == 1, touching == 2 ? apex(off) : -1};
            }
            if (twin(out) < 0) {
                points_.outside();
            }
            t = twin(out) / 3;
        }
    }

    /// Puts a vertex in its place, and notes the edges opposite to it as suspects.
    void split(const Place& place, int vertex) {
        if (place.on_edge) {
            split_edge(place.half_edge, vertex);
        } else {
            split_triangle(place.half_edge / 3, vertex);
        }
        around(vertex, [&](int h) {
            suspects_.push_back(next(h));
            return false;
        });
    }

    void split_triangle(int t, int vertex) {
        const int h = 3 * t;
        const int n = grow(2);
        const int a = corner(h);
        const int b = corner(h + 1);
        const int c = corner(h + 2);
        retile(std::array<NumberedTriangle, 3>{{{n, {b, c, vertex}}, {n + 1, {c, a, vertex}}, {t, {a, b, vertex}}}},
               {beyond(h), beyond(h + 1), beyond(h + 2)});
    }

    /// The halves of a constraint keep its label.
    void split_edge(int h, int vertex) {
        const int g = twin(h);
        const int value = label(h);
        const int a = corner(h);
        const int b = target(h);
        const int n = grow(g < 0 ? 1 : 2);
        const auto here = Points::divided(h / 3, n, {a, b, apex(h), vertex});
        if (g < 0) {
            retile(here, {beyond(next(h)), beyond(prev(h))});
        } else {
            const auto there = Points::divided(g / 3, n + 1, {b, a, apex(g), vertex});
            retile(std::array<NumberedTriangle, 4>{here[0], here[1], there[0], there[1]},
                   {beyond(next(h)), beyond(prev(h)), beyond(next(g)), beyond(prev(g))});
        }
        set_label(edge_between(a, vertex), value);
        set_label(edge_between(vertex, b), value);
    }

    /// Whether the two triangles at an edge form a strictly convex quadrangle.
    bool flippable(int h) const {
        const int g = twin(h);
        return points_.orient(apex(g), target(h), apex(h)) > 0 && points_.orient(apex(h), corner(h), apex(g)) > 0;
    }

    /// Replaces an edge by the other diagonal of its two triangles.
    void flip(int h) {
        const int g = twin(h);
        retile(Points::flipped(h / 3, g / 3, {corner(h), target(h), apex(h), apex(g)}),
               {beyond(next(h)), beyond(prev(h)), beyond(next(g)), beyond(prev(g))});
    }

    /// Flips suspected edges that are no constraints where `improves` allows it, and suspects the edges around them
    /// (Lawson 1977).
    template <typename Improves>
    void flip_suspects(Improves&& improves) {
        while (!suspects_.empty()) {
            const int h = suspects_.back();
            suspects_.pop_back();
            if (twin(h) < 0 || label(h) >= 0 || !improves(h)) {
                continue;
            }
            const auto more = Points::suspects(h - h % 3, twin(h) - twin(h) % 3);
            flip(h);
            suspects_.insert(suspects_.end(), more.begin(), more.end());
        }
    }

    /// On which side of the segment's line a vertex lies. The vertices that the segment has passed need no computation:
    /// zero is the most expensive sign of constructed points.
    int side(const Segment& segment, int v) const {
        const bool passed = v == segment.from || v == segment.to || v == segment.at || v == segment.before;
        return passed ? 0 : points_.orient(segment.from, segment.to, v);
    }

    /// Goes along the segment to the next vertex on it, or the first constraint, and collects the edges that it
    /// crosses.
    Stop walk(const Segment& segment, Edges& crossed) const {
        if (edge_between(segment.at, segment.to) >= 0) {
            return {segment.to, -1};
        }
        Stop stop;
        int h = -1;
        around(segment.at, [&](int s) {
            const int sides[2] = {side(segment, target(s)), side(segment, apex(s))};
            for (const auto& [v, beside] : {std::pair(target(s), sides[0]), std::pair(apex(s), sides[1])}) {
                if (stop.vertex < 0 && beside == 0 && v != segment.before && points_.ahead(segment.at, segment.to, v)) {
                    stop.vertex = v;
                }
            }
            h = sides[0] < 0 && sides[1] > 0 ? next(s) : -1;
            return stop.vertex >= 0 || h >= 0;
        });
        while (stop.vertex < 0 && h >= 0) {
            if (label(h) >= 0) {
                return {-1, h};
            }
            crossed.push_back({corner(h), target(h)});
            h = twin(h);
            if (h >= 0) {
                const int beside = side(segment, apex(h));
                stop.vertex = beside == 0 ? apex(h) : -1;
                // The walk goes on through the edge with one end on either side; h runs from its left to its right.
                h = beside > 0 ? next(h) : prev(h);
            }
        }
        return stop;
    }

    /// Makes the piece of the segment up to `end` an edge: flips the edges that cross it, none of them a constraint, as
    /// soon as their quadrangles are convex (Sloan 1993).
    void clear_way(const Segment& segment, int end, const Edges& crossed) {
        std::deque<std::array<int, 2>> todo(crossed.begin(), crossed.end());
        const std::size_t most = 64 + 16 * todo.size() * todo.size();
        for (std::size_t steps = 0; !todo.empty(); ++steps) {
            check_cancelled(progress_);
            if (steps > most) {
                throw TopologyError(phrases::kInconsistentDivision);
            }
            const int h = find_edge(todo.front()[0], todo.front()[1]);
            const int p = apex(h);
            const int q = apex(twin(h));
            if (!flippable(h)) {
                todo.push_back(todo.front());
            } else {
                flip(h);
                const bool touches = p == segment.at || p == end || q == segment.at || q == end;
                if (!touches && side(segment, p) * side(segment, q) < 0) {
                    const int found = find_edge(p, q);
                    const int diagonal = found / 3 == h / 3 ? found : twin(found);
                    todo.push_back({corner(diagonal), target(diagonal)});
                }
            }
            todo.pop_front();
        }
    }

    Points points_;
    const Progress* progress_;
    std::vector<int> corner_;
    std::vector<int> twin_;
    std::vector<int> label_;
    std::vector<int> out_;       ///< by vertex: a half-edge that leaves it, -1 when it is not placed
    std::vector<int> suspects_;  ///< half-edges that flip_suspects examines, the last one first

  private:
    /// An edge of a region that is divided anew, and what lies beyond it.
    struct Beyond {
        int from;
        int to;
        int twin;
        int label;
    };
    Beyond beyond(int h) const { return {corner(h), target(h), twin(h), label(h)}; }

    /// Adds triangles; returns the first one's number.
    int grow(int triangles) {
        const int first = triangle_count();
        for (std::vector<int>* of_half_edges : {&corner_, &twin_, &label_}) {
            of_half_edges->resize(of_half_edges->size() + 3 * static_cast<std::size_t>(triangles), -1);
        }
        return first;
    }

    /// Covers a region by other triangles. Edges inside it have no label.
    template <std::size_t N>
    void retile(const std::array<NumberedTriangle, N>& tiles, std::initializer_list<Beyond> region) {
        for (const auto& [number, corners] : tiles) {
            for (int k = 0; k < 3; ++k) {
                const int v = corners[static_cast<std::size_t>(k)];
                corner_[static_cast<std::size_t>(3 * number + k)] = v;
                out_[static_cast<std::size_t>(v)] = 3 * number + k;
            }
        }
        for (const auto& [number, corners] : tiles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const int from = corners[k];
                const int to = corners[k == 2 ? 0 : k + 1];
                const int h = 3 * number + static_cast<int>(k);
                const Beyond* outer = std::find_if(region.begin(), region.end(),
                                                   [&](const Beyond& one) { return one.from == from && one.to == to; });
                label_[static_cast<std::size_t>(h)] = outer != region.end() ? outer->label : -1;
                link(h, outer != region.end() ? outer->twin : within(tiles, to, from));
            }
        }
    }

    template <std::size_t N>
    static int within(const std::array<NumberedTriangle, N>& tiles, int from, int to) {
        for (const auto& [number, corners] : tiles) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (corners[k] == from && corners[k == 2 ? 0 : k + 1] == to) {
                    return 3 * number + static_cast<int>(k);
                }
            }
        }
        return -1;
    }
};

}  // namespace mq::mesh
