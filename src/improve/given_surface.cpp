// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/given_surface.h"

#include "improve/thin.h"

namespace mq::improve {

namespace {

std::vector<Triangle> edges_as_triangles(const EditableMesh& mesh) {
    std::vector<Triangle> result;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        for (const int w : mesh.sharp_neighbours(v)) {
            if (v < w) {
                result.push_back({v, w, w});
            }
        }
    }
    return result;
}

}  // namespace

GivenSurface::GivenSurface(const mesh::TriangleMesh& given, const EditableMesh& edges)
    : given_(given),
      sharp_(edges_as_triangles(edges)),
      tree_(given.vertices, given.triangles),
      curves_(given.vertices, sharp_) {}

Vec3 GivenSurface::project(const Vec3& p) const {
    return in_single(tree_.nearest(p).point);
}

Vec3 GivenSurface::project_to_sharp_edges(const Vec3& p) const {
    return in_single(curves_.nearest(p).point);
}

Vec3 GivenSurface::normal(const Vec3& p) const {
    const Triangle& t = given_.triangles[static_cast<std::size_t>(tree_.nearest(p).triangle)];
    return sound_normal({given_.vertices[t[0]], given_.vertices[t[1]], given_.vertices[t[2]]});
}

Vec3 in_single(const Vec3& p) {
    return p.cast<float>().cast<double>();
}

}  // namespace mq::improve
