// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "triangulate/work_mesh/classified_mesh.h"

/// Small classified meshes with all kinds of connections at edges, without a CAD model.
namespace mq::triangulate::samples {

/// Puts faces together.
class SurfaceBuilder {
  public:
    triangulate::ClassifiedMesh mesh;

    int vertex(const Vec3& point) { return mesh.add_vertex(point, {0, mesh.vertex_count()}); }

    /// A face of (columns x rows) squares of (u, v), two triangles each. `vertices` run row by row. Sides within the
    /// face are linked; the others become segments, shared with every face that has the same two vertices.
    void grid(int face, int columns, int rows, const std::vector<int>& vertices) {
        std::vector<int> sites;
        for (int j = 0; j <= rows; ++j) {
            for (int i = 0; i <= columns; ++i) {
                sites.push_back(mesh.add_site({vertices[sites.size()], Vec2(i, j), Vec3(0, 0, 1)}));
            }
        }
        std::map<std::pair<int, int>, int> open;  // by sites
        const auto at = [&](int i, int j) { return sites[j * (columns + 1) + i]; };
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) {
                add(face, {at(i, j), at(i + 1, j), at(i + 1, j + 1)}, open);
                add(face, {at(i, j), at(i + 1, j + 1), at(i, j + 1)}, open);
            }
        }
        for (const auto& [ends, h] : open) {
            bind(h);
        }
    }

  private:
    void add(int face, const std::array<int, 3>& sites, std::map<std::pair<int, int>, int>& open) {
        const int t = mesh.add_triangle(sites, face);
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const int a = mesh.site_of(h);
            const int b = mesh.site_of(triangulate::ClassifiedMesh::next(h));
            const auto found = open.find({b, a});
            if (found != open.end()) {
                mesh.link(h, found->second);
                open.erase(found);
            } else {
                open[{a, b}] = h;
            }
        }
    }

    void bind(int h) {
        const int a = mesh.vertex_of(h);
        const int b = mesh.vertex_of(triangulate::ClassifiedMesh::next(h));
        const auto [found, fresh] = segments_.emplace(std::minmax(a, b), mesh.segment_count());
        if (fresh) {
            mesh.add_segment(found->second, {std::min(a, b), std::max(a, b)}, {0.0, 1.0});
        }
        mesh.bind(h, found->second, uses_++);
    }

    std::map<std::pair<int, int>, int> segments_;
    int uses_ = 0;
};

inline std::vector<int> sheet_vertices(SurfaceBuilder& builder, int columns, int rows) {
    std::vector<int> vertices;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            vertices.push_back(builder.vertex(Vec3(i, j, 0)));
        }
    }
    return vertices;
}

/// One flat face: every segment has one use.
inline triangulate::ClassifiedMesh sheet(int columns, int rows) {
    SurfaceBuilder builder;
    builder.grid(0, columns, rows, sheet_vertices(builder, columns, rows));
    return builder.mesh;
}

/// Faces that meet in one straight row of segments: two of them make an edge, three a non-manifold edge.
inline triangulate::ClassifiedMesh book(int pages, int columns, int rows) {
    SurfaceBuilder builder;
    std::vector<int> spine;
    for (int i = 0; i <= columns; ++i) {
        spine.push_back(builder.vertex(Vec3(i, 0, 0)));
    }
    for (int page = 0; page < pages; ++page) {
        std::vector<int> vertices = spine;
        const double angle = 2.0 * page;
        for (int j = 1; j <= rows; ++j) {
            for (int i = 0; i <= columns; ++i) {
                vertices.push_back(builder.vertex(Vec3(i, j * std::cos(angle), j * std::sin(angle))));
            }
        }
        builder.grid(page, columns, rows, vertices);
    }
    return builder.mesh;
}

/// One face around an axis: both uses of the seam's segments lie on it.
inline triangulate::ClassifiedMesh tube(int columns, int rows) {
    SurfaceBuilder builder;
    std::vector<int> vertices;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const double angle = 2.0 * M_PI * i / columns;
            vertices.push_back(builder.vertex(Vec3(std::cos(angle), std::sin(angle), j)));
        }
        vertices.push_back(vertices[vertices.size() - columns]);
    }
    builder.grid(0, columns, rows, vertices);
    return builder.mesh;
}

}  // namespace mq::triangulate::samples
