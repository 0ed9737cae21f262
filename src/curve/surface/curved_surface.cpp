// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/curved_surface.h"

#include <algorithm>

namespace mq::curve {

int CurvedSurface::add_vertex(const elements::Vertex& vertex) {
    shapes.vertices.push_back(vertex);
    stars_.resize(shapes.vertices.size());
    return static_cast<int>(shapes.vertices.size()) - 1;
}

int CurvedSurface::add_triangle(const std::array<int, 3>& corners, int face) {
    const int index = static_cast<int>(triangles.size());
    SurfaceTriangle triangle;
    triangle.corners = corners;
    triangle.face = face;
    triangles.push_back(triangle);
    stars_.add(index, corners);
    return index;
}

void CurvedSurface::remove_triangle(int triangle) {
    SurfaceTriangle& t = triangles[static_cast<std::size_t>(triangle)];
    t.alive = false;
    stars_.remove(triangle, t.corners);
}

void CurvedSurface::withdraw_triangle() {
    remove_triangle(static_cast<int>(triangles.size()) - 1);
    triangles.pop_back();
}

void CurvedSurface::revive_triangle(int triangle) {
    SurfaceTriangle& t = triangles[static_cast<std::size_t>(triangle)];
    t.alive = true;
    stars_.add(triangle, t.corners);
}

const Segment* CurvedSurface::segment(int a, int b) const {
    const auto found = segments.find(pair_key(a, b));
    return found == segments.end() ? nullptr : &found->second;
}

void CurvedSurface::set_segment(int a, int b, int edge, double t_a, double t_b) {
    segments[pair_key(a, b)] = a < b ? Segment{edge, t_a, t_b} : Segment{edge, t_b, t_a};
}

double CurvedSurface::t_of(int vertex, int other) const {
    const Segment& s = segments.at(pair_key(vertex, other));
    return vertex < other ? s.t_low : s.t_high;
}

const Vec2* CurvedSurface::uv_of(int vertex, int face) const {
    const auto found = uv.find(key(vertex, face));
    return found == uv.end() ? nullptr : &found->second;
}

std::size_t CurvedSurface::invalid() const {
    return static_cast<std::size_t>(std::count_if(
        triangles.begin(), triangles.end(), [](const SurfaceTriangle& t) { return t.alive && !(t.quality > 0.0); }));
}

std::size_t CurvedSurface::alive() const {
    return static_cast<std::size_t>(
        std::count_if(triangles.begin(), triangles.end(), [](const SurfaceTriangle& t) { return t.alive; }));
}

}  // namespace mq::curve
