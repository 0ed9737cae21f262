// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/reference_surface.h"

#include "mesh/quality/triangle_quality.h"

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

ReferenceSurface::ReferenceSurface(const mesh::TriangleMesh& given, const EditableMesh& edges)
    : given_(given),
      sharp_(edges_as_triangles(edges)),
      tree_(given.vertices, given.triangles),
      curves_(given.vertices, sharp_) {}

bool ReferenceSurface::within(const Vec3& p, double distance) const {
    const std::int32_t found = tree_.any_within(p, distance, last_);
    last_ = found >= 0 ? found : last_;
    return found >= 0;
}

bool ReferenceSurface::sharp_edges_within(const Vec3& p, double distance) const {
    const std::int32_t found = sharp_.empty() ? -1 : curves_.any_within(p, distance, last_sharp_);
    last_sharp_ = found >= 0 ? found : last_sharp_;
    return found >= 0;
}

Vec3 ReferenceSurface::project(const Vec3& p) const {
    const mesh::ClosestPoint near = tree_.nearest_from(p, last_);
    last_ = near.triangle;
    return in_single(near.point);
}

Vec3 ReferenceSurface::project_to_sharp_edges(const Vec3& p) const {
    const mesh::ClosestPoint near = curves_.nearest_from(p, last_sharp_);
    last_sharp_ = near.triangle;
    return in_single(near.point);
}

ReferenceSurface::SurfaceProjection ReferenceSurface::foot(const Vec3& p) const {
    const mesh::ClosestPoint near = tree_.nearest_from(p, last_);
    last_ = near.triangle;
    const Triangle& t = given_.triangles[static_cast<std::size_t>(near.triangle)];
    return {near.distance, mesh::robust_normal({given_.vertices[t[0]], given_.vertices[t[1]], given_.vertices[t[2]]})};
}

Vec3 in_single(const Vec3& p) {
    return p.cast<float>().cast<double>();
}

}  // namespace mq::improve
