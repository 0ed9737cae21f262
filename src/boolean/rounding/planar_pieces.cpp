// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/planar_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mq::boolean {

PlanarPieces::PlanarPieces(const std::vector<Vec3>& vertices, const Triangle& corners)
    : vertices_(vertices), vertex_(corners.begin(), corners.end()) {
    // Areas below this fraction of the triangle's are rounding error of points on one line.
    constexpr double kFlat = 1e-12;
    const auto at = [&](std::size_t k) -> const Vec3& { return vertices_[static_cast<std::size_t>(corners[k])]; };
    origin_ = at(0);
    along_ = (at(1) - at(0)).normalized();
    aside_ = (at(1) - at(0)).cross(at(2) - at(0)).cross(along_).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
        place_.push_back(in_plane(at(k)));
    }
    flat_ = kFlat * std::abs(area(0, 1, 2));
}

void PlanarPieces::add_on_edge(std::size_t k, double s, std::int32_t w) {
    on_edge_[k].push_back(static_cast<int>(place_.size()));
    place_.emplace_back((1.0 - s) * place_[k] + s * place_[(k + 1) % 3]);
    vertex_.push_back(w);
}

void PlanarPieces::add_inside(std::int32_t w) {
    inside_.push_back(static_cast<int>(place_.size()));
    place_.push_back(in_plane(vertices_[static_cast<std::size_t>(w)]));
    vertex_.push_back(w);
}

std::vector<Triangle> PlanarPieces::run() {
    pieces_.assign(1, {{0, 1, 2}, {-1, -1, -1}});
    for (std::size_t k = 0; k < 3; ++k) {
        int half = 0;
        while (twin(half) != -1 || origin(half) != static_cast<int>(k)) {
            ++half;
        }
        for (const int point : on_edge_[k]) {
            half = split_edge(half, point);
        }
    }
    for (const int point : inside_) {
        split_inside(point);
    }
    improve();
    std::vector<Triangle> result;
    for (const Piece& p : pieces_) {
        const auto vertex = [&](std::size_t k) { return vertex_[static_cast<std::size_t>(p.point[k])]; };
        result.push_back({vertex(0), vertex(1), vertex(2)});
    }
    return result;
}

double PlanarPieces::area(int a, int b, int c) const {
    const Vec2 p = place(b) - place(a);
    const Vec2 q = place(c) - place(a);
    return p.x() * q.y() - p.y() * q.x();
}

void PlanarPieces::link(int half, int other) {
    piece(half).twin[static_cast<std::size_t>(half % 3)] = other;
    if (other >= 0) {
        piece(other).twin[static_cast<std::size_t>(other % 3)] = half;
    }
}

int PlanarPieces::new_piece(int a, int b, int c) {
    pieces_.push_back({{a, b, c}, {-1, -1, -1}});
    return 3 * static_cast<int>(pieces_.size()) - 3;
}

/// Splits a half-edge on the border at a point; returns the half-edge from the point on.
int PlanarPieces::split_edge(int half, int point) {
    const int end = origin(next(half));
    const int apex = origin(prev(half));
    const int beyond = twin(next(half));
    const int added = new_piece(point, end, apex);
    piece(half).point[static_cast<std::size_t>(next(half) % 3)] = point;
    link(next(added), beyond);
    link(next(half), prev(added));
    return added;
}

/// Splits the piece in which a point lies, or is outside of by the shortest distance, in three.
void PlanarPieces::split_inside(int point) {
    int best = 0;
    double farthest_inside = -std::numeric_limits<double>::infinity();
    for (int first = 0; first < 3 * static_cast<int>(pieces_.size()); first += 3) {
        double least = std::numeric_limits<double>::infinity();
        for (int half = first; half < first + 3; ++half) {
            const int a = origin(half);
            const int b = origin(next(half));
            least = std::min(least, area(a, b, point) / (place(b) - place(a)).norm());
        }
        if (least > farthest_inside) {
            farthest_inside = least;
            best = first;
        }
    }
    const Piece old = piece(best);
    const int one = new_piece(old.point[1], old.point[2], point);
    const int two = new_piece(old.point[2], old.point[0], point);
    piece(best).point[2] = point;
    link(one, old.twin[1]);
    link(two, old.twin[2]);
    link(next(best), prev(one));
    link(next(one), prev(two));
    link(next(two), prev(best));
}

bool PlanarPieces::should_flip(int half) const {
    const int other = twin(half);
    if (other < 0) {
        return false;
    }
    // Lengths that differ by less are rounding error: swaps end.
    constexpr double kShorter = 1.0 - 1e-9;
    const int a = origin(half);
    const int b = origin(next(half));
    const int c = origin(prev(half));
    const int d = origin(prev(other));
    return (place(c) - place(d)).squaredNorm() < kShorter * (place(a) - place(b)).squaredNorm() &&
           area(d, b, c) > flat_ && area(c, a, d) > flat_;
}

void PlanarPieces::flip(int half) {
    const int other = twin(half);
    const int a = origin(half);
    const int b = origin(next(half));
    const int c = origin(prev(half));
    const int d = origin(prev(other));
    const int bc = twin(next(half));
    const int ca = twin(prev(half));
    const int ad = twin(next(other));
    const int db = twin(prev(other));
    const int s = half - half % 3;
    const int t = other - other % 3;
    piece(s).point = {d, b, c};
    piece(t).point = {c, a, d};
    link(s, db);
    link(s + 1, bc);
    link(t, ca);
    link(t + 1, ad);
    link(s + 2, t + 2);
}

/// Every swap shortens a diagonal, so that this ends.
void PlanarPieces::improve() {
    std::vector<int> todo;
    for (int half = 0; half < 3 * static_cast<int>(pieces_.size()); ++half) {
        todo.push_back(half);
    }
    while (!todo.empty()) {
        const int half = todo.back();
        todo.pop_back();
        if (should_flip(half)) {
            const int s = half - half % 3;
            const int t = twin(half) - twin(half) % 3;
            flip(half);
            todo.insert(todo.end(), {s, s + 1, t, t + 1});
        }
    }
}

}  // namespace mq::boolean
