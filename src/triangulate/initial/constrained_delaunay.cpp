// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/constrained_delaunay.h"

#include <algorithm>

#include "base/error.h"
#include "base/predicates.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::triangulate {

int PlanePoints::orient(int a, int b, int c) const {
    return orient2d(points[a], points[b], points[c]);
}

bool PlanePoints::ahead(int a, int b, int c) const {
    return (points[c] - points[a]).dot(points[b] - points[a]) > 0.0;
}

void PlanePoints::outside() {
    throw InvalidInput(phrases::kOutsideFrame);
}

ConstrainedDelaunay::ConstrainedDelaunay(const Vec2& low, const Vec2& high, std::size_t expected)
    : ConstrainedTriangulation(PlanePoints{}) {
    const std::size_t vertices = expected + kFrame;
    points_.points.reserve(vertices);
    out_.reserve(vertices);
    for (std::vector<int>* of_half_edges : {&corner_, &twin_, &label_}) {
        of_half_edges->reserve(6 * vertices);
    }
    const double reach = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
    const Vec2 margin = Vec2::Constant(10.0 * (high - low).maxCoeff() + 1e-9 * std::max(1.0, reach));
    const Vec2 a = low - margin;
    const Vec2 c = high + margin;
    for (const Vec2& corner : {a, Vec2(c.x(), a.y()), c, Vec2(a.x(), c.y())}) {
        add_vertex(corner);
    }
    add_triangle(0, 1, 2);
    add_triangle(0, 2, 3);
    link(2, 3);
}

int ConstrainedDelaunay::insert(const Vec2& p, bool off_constraints) {
    const int v = add_vertex(p);
    const Place place = locate(last_, v);
    const bool refused = off_constraints && place.on_edge && label(place.half_edge) >= 0;
    if (!refused) {
        last_ = place.half_edge / 3;
    }
    if (refused || place.vertex >= 0) {
        points_.points.pop_back();
        out_.pop_back();
        return refused ? -1 : place.vertex;
    }
    split(place, v);
    if (place.on_edge) {  // in the order of the triangles' numbers, which decides between cocircular points
        std::reverse(suspects_.begin(), suspects_.end());
    }
    legalise();
    return v;
}

bool ConstrainedDelaunay::flip_edge(int h) {
    if (twin(h) < 0 || label(h) >= 0 || !flippable(h)) {
        return false;
    }
    flip(h);
    return true;
}

void ConstrainedDelaunay::legalise() {
    flip_suspects(
        [&](int h) { return in_circle(point(corner(h)), point(target(h)), point(apex(h)), point(apex(twin(h)))) > 0; });
}

std::optional<ConstrainedDelaunay::Obstacle> ConstrainedDelaunay::insert_constraint(int a, int b, int value) {
    Edges crossed;
    const Segment segment{a, b, -1, a};
    const Stop stop = walk(segment, crossed);
    if (stop.vertex != b) {
        return Obstacle{stop.vertex, stop.constraint < 0 ? -1 : label(stop.constraint)};
    }
    clear_way(segment, b, crossed);
    const int h = find_edge(a, b);
    if (label(h) < 0) {  // an edge keeps its first label
        set_label(h, value);
    }
    for (const auto& edge : crossed) {  // the flips left non-Delaunay edges around the constraint
        for (const int v : edge) {
            around(v, [&](int s) {
                suspects_.insert(suspects_.end(), {s, next(s)});
                return false;
            });
        }
    }
    legalise();
    return std::nullopt;
}

}  // namespace mq::triangulate
