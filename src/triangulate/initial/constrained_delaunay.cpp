// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/constrained_delaunay.h"

#include <algorithm>
#include <deque>
#include <random>

#include "base/error.h"
#include "base/predicates.h"

namespace mq::triangulate {

ConstrainedDelaunay::ConstrainedDelaunay(const Vec2& low, const Vec2& high, std::size_t expected) {
    const std::size_t points = expected + kFrame;
    points_.reserve(points);
    half_edge_of_.reserve(points);
    for (std::vector<int>* of_half_edges : {&corner_, &twin_, &label_}) {
        of_half_edges->reserve(6 * points);
    }
    const double reach = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
    const Vec2 margin = Vec2::Constant(10.0 * (high - low).maxCoeff() + 1e-9 * std::max(1.0, reach));
    const Vec2 a = low - margin;
    const Vec2 c = high + margin;
    points_ = {a, Vec2(c.x(), a.y()), c, Vec2(a.x(), c.y())};
    half_edge_of_.assign(4, -1);
    corner_.resize(6);
    twin_.assign(6, -1);
    label_.assign(6, -1);
    set_triangle(0, 0, 1, 2);
    set_triangle(1, 0, 2, 3);
    attach(2, 3, -1);
}

void ConstrainedDelaunay::set_triangle(int t, int a, int b, int c) {
    const int v[3] = {a, b, c};
    for (int i = 0; i < 3; ++i) {
        corner_[3 * t + i] = v[i];
        half_edge_of_[v[i]] = 3 * t + i;
    }
}

void ConstrainedDelaunay::attach(int h, int g, int label) {
    twin_[h] = g;
    label_[h] = label;
    if (g >= 0) {
        twin_[g] = h;
        label_[g] = label;
    }
}

int ConstrainedDelaunay::find_edge(int a, int b) const {
    const int start = half_edge_of_[a];
    for (int h = start;;) {
        if (corner_[next(h)] == b) {
            return h;
        }
        const int g = twin_[prev(h)];
        if (g == start) {
            return -1;
        }
        if (g < 0) {
            break;
        }
        h = g;
    }
    for (int g = twin_[start]; g >= 0; g = twin_[next(g)]) {  // a is on the frame: search clockwise, too
        if (corner_[next(next(g))] == b) {
            return next(g);
        }
    }
    return -1;
}

ConstrainedDelaunay::Place ConstrainedDelaunay::locate(const Vec2& p) const {
    // Visibility walk. On a Delaunay triangulation it cannot cycle; beside constraints and flipped edges it can.
    // Starting with another edge in every step breaks most cycles, and a randomly drawn one breaks all (Devillers,
    // Pion, Teillaud 2002). The constant is the number of steps before edges are drawn at random.
    constexpr int kInTurn = 1000;
    std::minstd_rand lot;
    int t = last_;
    unsigned turn = 0;
    for (int step = 0;; ++step) {
        int out = -1;
        int edge = -1;
        int touching = 0;
        for (unsigned k = 0; k < 3; ++k) {
            const int h = 3 * t + static_cast<int>((k + turn) % 3);
            const int side = orient2d(points_[corner_[h]], points_[corner_[next(h)]], p);
            if (side < 0) {
                out = h;
                break;
            }
            if (side == 0) {
                edge = h;
                ++touching;
            }
        }
        if (out >= 0) {
            if (twin_[out] < 0) {
                throw InvalidInput("a point lies outside of the frame of its triangulation");
            }
            t = twin_[out] / 3;
            turn = step < kInTurn ? turn + 1 : static_cast<unsigned>(lot());
            continue;
        }
        if (touching == 2) {
            for (int i = 0; i < 3; ++i) {
                if (points_[corner_[3 * t + i]] == p) {
                    return {3 * t + i, false, corner_[3 * t + i]};
                }
            }
        }
        return {touching > 0 ? edge : 3 * t, touching > 0, -1};
    }
}

int ConstrainedDelaunay::insert(const Vec2& p) {
    return insert_at(locate(p), p);
}

int ConstrainedDelaunay::insert_off_constraints(const Vec2& p) {
    const Place place = locate(p);
    return place.on_edge && label_[place.half_edge] >= 0 ? -1 : insert_at(place, p);
}

int ConstrainedDelaunay::insert_at(const Place& place, const Vec2& p) {
    last_ = place.half_edge / 3;
    if (place.vertex >= 0) {
        return place.vertex;
    }
    const int v = vertex_count();
    points_.push_back(p);
    half_edge_of_.push_back(-1);
    if (place.on_edge) {
        insert_on_edge(place.half_edge, v);
    } else {
        insert_in_triangle(place.half_edge / 3, v);
    }
    legalise();
    return v;
}

void ConstrainedDelaunay::insert_in_triangle(int t, int v) {
    const int h = 3 * t;
    const int a = corner_[h];
    const int b = corner_[h + 1];
    const int c = corner_[h + 2];
    const int bc = twin_[h + 1];
    const int ca = twin_[h + 2];
    const int label_bc = label_[h + 1];
    const int label_ca = label_[h + 2];
    const int n = triangle_count();
    corner_.resize(corner_.size() + 6);
    twin_.resize(twin_.size() + 6, -1);
    label_.resize(label_.size() + 6, -1);
    set_triangle(n, b, c, v);
    set_triangle(n + 1, c, a, v);
    set_triangle(t, a, b, v);
    attach(3 * n, bc, label_bc);
    attach(3 * n + 3, ca, label_ca);
    attach(h + 1, 3 * n + 2, -1);
    attach(3 * n + 1, 3 * n + 5, -1);
    attach(3 * n + 4, h + 2, -1);
    suspects_.insert(suspects_.end(), {h, 3 * n, 3 * n + 3});
}

void ConstrainedDelaunay::insert_on_edge(int h, int v) {
    const int g = twin_[h];
    const int label = label_[h];
    const int t = h / 3;
    const int o = g / 3;
    const int a = corner_[h];
    const int b = corner_[next(h)];
    const int c = corner_[prev(h)];
    const int d = corner_[prev(g)];
    const int bc = twin_[next(h)];
    const int ca = twin_[prev(h)];
    const int ad = twin_[next(g)];
    const int db = twin_[prev(g)];
    const int labels[4] = {label_[next(h)], label_[prev(h)], label_[next(g)], label_[prev(g)]};
    const int n = triangle_count();
    corner_.resize(corner_.size() + 6);
    twin_.resize(twin_.size() + 6, -1);
    label_.resize(label_.size() + 6, -1);
    set_triangle(t, c, a, v);
    set_triangle(n, b, c, v);
    set_triangle(o, d, b, v);
    set_triangle(n + 1, a, d, v);
    attach(3 * t, ca, labels[1]);
    attach(3 * n, bc, labels[0]);
    attach(3 * o, db, labels[3]);
    attach(3 * n + 3, ad, labels[2]);
    attach(3 * n + 1, 3 * t + 2, -1);     // c-v
    attach(3 * o + 2, 3 * n + 4, -1);     // v-d
    attach(3 * t + 1, 3 * n + 5, label);  // a-v
    attach(3 * o + 1, 3 * n + 2, label);  // b-v
    suspects_.insert(suspects_.end(), {3 * t, 3 * n, 3 * o, 3 * n + 3});
}

void ConstrainedDelaunay::flip(int h) {
    const int g = twin_[h];
    const int t = h / 3;
    const int o = g / 3;
    const int a = corner_[h];
    const int b = corner_[next(h)];
    const int c = corner_[prev(h)];
    const int d = corner_[prev(g)];
    const int bc = twin_[next(h)];
    const int ca = twin_[prev(h)];
    const int ad = twin_[next(g)];
    const int db = twin_[prev(g)];
    const int labels[4] = {label_[next(h)], label_[prev(h)], label_[next(g)], label_[prev(g)]};
    set_triangle(t, a, d, c);
    set_triangle(o, d, b, c);
    attach(3 * t, ad, labels[2]);
    attach(3 * t + 2, ca, labels[1]);
    attach(3 * o, db, labels[3]);
    attach(3 * o + 1, bc, labels[0]);
    attach(3 * t + 1, 3 * o + 2, -1);
}

bool ConstrainedDelaunay::flip_edge(int h) {
    const int g = twin_[h];
    if (g < 0 || label_[h] >= 0) {
        return false;
    }
    const Vec2& a = points_[corner_[h]];
    const Vec2& b = points_[corner_[next(h)]];
    const Vec2& c = points_[corner_[prev(h)]];
    const Vec2& d = points_[corner_[prev(g)]];
    if (orient2d(a, d, c) <= 0 || orient2d(d, b, c) <= 0) {
        return false;
    }
    flip(h);
    return true;
}

void ConstrainedDelaunay::legalise() {
    while (!suspects_.empty()) {
        const int h = suspects_.back();
        suspects_.pop_back();
        const int g = twin_[h];
        if (g < 0 || label_[h] >= 0) {
            continue;
        }
        const int a = corner_[h];
        const int b = corner_[next(h)];
        const int c = corner_[prev(h)];
        const int d = corner_[prev(g)];
        if (in_circle(points_[a], points_[b], points_[c], points_[d]) > 0) {
            const int t = h / 3;
            const int o = g / 3;
            flip(h);
            suspects_.insert(suspects_.end(), {3 * t, 3 * t + 2, 3 * o, 3 * o + 1});
        }
    }
}

bool ConstrainedDelaunay::crosses(int a, int b, int h) const {
    const int c = corner_[h];
    const int d = corner_[next(h)];
    if (c == a || c == b || d == a || d == b) {
        return false;
    }
    const Vec2& pa = points_[a];
    const Vec2& pb = points_[b];
    return orient2d(pa, pb, points_[c]) * orient2d(pa, pb, points_[d]) < 0 &&
           orient2d(points_[c], points_[d], pa) * orient2d(points_[c], points_[d], pb) < 0;
}

std::optional<ConstrainedDelaunay::Obstacle> ConstrainedDelaunay::collect_crossings(
    int a, int b, std::vector<std::array<int, 2>>& crossed) const {
    const Vec2& pa = points_[a];
    const Vec2& pb = points_[b];
    int h = -1;  // the edge opposite a through which a-b leaves the star of a
    const int start = half_edge_of_[a];
    for (int s = start;;) {
        const int right = corner_[next(s)];
        const int left = corner_[prev(s)];
        const int side_right = orient2d(pa, pb, points_[right]);
        const int side_left = orient2d(pa, pb, points_[left]);
        if (side_right == 0 && (points_[right] - pa).dot(pb - pa) > 0.0) {
            return Obstacle{right, -1};
        }
        if (side_right < 0 && side_left > 0) {
            h = next(s);
            break;
        }
        s = twin_[prev(s)];
        if (s == start || s < 0) {
            break;
        }
    }
    if (h < 0) {
        return Obstacle{};
    }
    for (;;) {
        if (label_[h] >= 0) {
            return Obstacle{-1, label_[h]};
        }
        crossed.push_back({corner_[h], corner_[next(h)]});
        const int g = twin_[h];
        if (g < 0) {
            return Obstacle{};
        }
        const int apex = corner_[prev(g)];
        if (apex == b) {
            return std::nullopt;
        }
        const int side = orient2d(pa, pb, points_[apex]);
        if (side == 0) {
            return Obstacle{apex, -1};
        }
        h = side > 0 ? next(g) : prev(g);
    }
}

// Sloan 1993: flip crossing edges whose quadrilateral is strictly convex, put the others back in the queue.
void ConstrainedDelaunay::remove_crossings(int a, int b, std::vector<std::array<int, 2>> crossed) {
    std::deque<std::array<int, 2>> queue(crossed.begin(), crossed.end());
    while (!queue.empty()) {
        const auto [c, d] = queue.front();
        queue.pop_front();
        const int h = find_edge(c, d);
        const int g = twin_[h];
        const int e = corner_[prev(h)];
        const int f = corner_[prev(g)];
        const bool convex =
            orient2d(points_[f], points_[d], points_[e]) > 0 && orient2d(points_[f], points_[e], points_[c]) > 0;
        if (!convex) {
            queue.push_back({c, d});
            continue;
        }
        const int t = h / 3;
        flip(h);
        const int diagonal = 3 * t + 1;
        if (crosses(a, b, diagonal)) {
            queue.push_back({corner_[diagonal], corner_[next(diagonal)]});
        }
    }
}

std::optional<ConstrainedDelaunay::Obstacle> ConstrainedDelaunay::insert_constraint(int a, int b, int label) {
    int h = find_edge(a, b);
    std::vector<std::array<int, 2>> crossed;
    if (h < 0) {
        if (const auto obstacle = collect_crossings(a, b, crossed)) {
            return obstacle;
        }
        remove_crossings(a, b, crossed);
        h = find_edge(a, b);
    }
    if (label_[h] < 0) {  // an edge keeps its first label
        attach(h, twin_[h], label);
    }
    for (const auto& [c, d] : crossed) {  // the flips left non-Delaunay edges around the constraint
        for (const int v : {c, d}) {
            const int start = half_edge_of_[v];
            int s = start;
            do {
                suspects_.push_back(s);
                suspects_.push_back(next(s));
                s = twin_[prev(s)];
            } while (s >= 0 && s != start);
        }
    }
    legalise();
    return std::nullopt;
}

}  // namespace mq::triangulate
