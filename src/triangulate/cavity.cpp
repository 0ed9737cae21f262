// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/cavity.h"

#include <algorithm>

#include "triangulate/corner_angle.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

constexpr std::size_t kMaxTriangles = 40;

bool aligned(const SurfaceMesh& mesh, int side, const Corner& p, double least) {
    const double a =
        alignment(corner_of(mesh, mesh.site_of(side)), corner_of(mesh, mesh.site_of(SurfaceMesh::next(side))), p);
    return a >= least && a > 0.0;
}

}  // namespace

Cavity grow_cavity(const SurfaceMesh& mesh, int half_edge, bool split, const Corner& p, double least) {
    Cavity c;
    const int start = SurfaceMesh::triangle_of(half_edge);
    c.triangles = {start};
    constexpr std::size_t kUsual = 8;
    std::vector<int> vertices;
    vertices.reserve(kUsual);
    c.rim.reserve(kUsual);
    for (int h = 3 * start; h < 3 * start + 3; ++h) {
        vertices.push_back(mesh.vertex_of(h));
        if (!split || h != half_edge) {
            c.rim.push_back(h);
        }
    }
    for (std::size_t i = 0; i < c.rim.size();) {
        const int side = c.rim[i];
        if (aligned(mesh, side, p, least)) {
            ++i;
            continue;
        }
        const int g = mesh.twin(side);
        if (g < 0) {
            c.segment = mesh.segment_of(side);
            return c;
        }
        const int apex = mesh.vertex_of(SurfaceMesh::prev(g));
        // An apex met before would be shut in: the cavity would close around it.
        if (c.triangles.size() >= kMaxTriangles ||
            (!split && narrow_corner_of(mesh, SurfaceMesh::triangle_of(g)) >= 0) ||
            std::find(vertices.begin(), vertices.end(), apex) != vertices.end()) {
            return c;
        }
        vertices.push_back(apex);
        c.triangles.push_back(SurfaceMesh::triangle_of(g));
        c.outside.push_back(g);
        c.rim[i] = SurfaceMesh::next(g);
        c.rim.push_back(SurfaceMesh::prev(g));
    }
    c.complete = true;
    return c;
}

}  // namespace mq::triangulate
