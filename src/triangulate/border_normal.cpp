// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/border_normal.h"

#include <algorithm>

#include "triangulate/corner_angle.h"
#include "triangulate/fold.h"

namespace mq::triangulate {

namespace {

using geometry::Query;
using mesh::SurfaceMesh;

// How far in at most, of the way: what is as large as a triangle is to be seen.
constexpr double kPartOfWay = 0.5;

// Its normal turns by almost a right angle from the triangle or from another corner's.
bool disagrees(const SurfaceMesh& mesh, int h) {
    const int next = SurfaceMesh::next(h);
    const int prev = SurfaceMesh::prev(h);
    const Vec3& normal = mesh.site(mesh.site_of(h)).normal;
    const Vec3 area = doubled_area(mesh, SurfaceMesh::triangle_of(h));
    return normal.dot(area) < kAlignedAtLast * area.norm() ||
           normal.dot(mesh.site(mesh.site_of(next)).normal) < kAlignedAtLast ||
           normal.dot(mesh.site(mesh.site_of(prev)).normal) < kAlignedAtLast;
}

WayIn way_to_centroid(const SurfaceMesh& mesh, int h) {
    const SurfaceMesh::Site& a = mesh.site(mesh.site_of(h));
    const SurfaceMesh::Site& b = mesh.site(mesh.site_of(SurfaceMesh::next(h)));
    const SurfaceMesh::Site& c = mesh.site(mesh.site_of(SurfaceMesh::prev(h)));
    return {(b.point + c.point - 2.0 * a.point) / 3.0, (b.uv + c.uv - 2.0 * a.uv) / 3.0};
}

}  // namespace

WayIn way_across(const SurfaceMesh& mesh, int half_edge) {
    const SurfaceMesh::Site& a = mesh.site(mesh.site_of(half_edge));
    const SurfaceMesh::Site& b = mesh.site(mesh.site_of(SurfaceMesh::next(half_edge)));
    const SurfaceMesh::Site& c = mesh.site(mesh.site_of(SurfaceMesh::prev(half_edge)));
    const Vec3 side = b.point - a.point;
    const double at = side.dot(c.point - a.point) / side.squaredNorm();
    return {c.point - a.point - at * side, c.uv - a.uv - at * (b.uv - a.uv)};
}

std::optional<Vec3> normal_a_little_inside(const Workspace& work, int face, const SurfaceMesh::Site& site,
                                           const WayIn& way) {
    const double length = way.step.norm();
    if (!(length > 0.0) || !(site.normal.squaredNorm() > 0.0)) {
        return std::nullopt;
    }
    const double part = std::min(kPartOfWay, work.unseen / length);
    const Vec2 uv = site.uv + part * way.uv_step;
    const geometry::Answer there =
        work.session.ask(Query::face_nearest(face, work.grid.to_part(site.point + part * way.step), uv.x(), uv.y()));
    const bool turned = there.found() && there.normal.squaredNorm() > 0.0 && there.normal.dot(site.normal) < kAligned;
    return turned ? std::optional<Vec3>(there.normal) : std::nullopt;
}

void take_normals_from_inside(Workspace& work) {
    SurfaceMesh& mesh = work.mesh;
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        const int t = SurfaceMesh::triangle_of(h);
        if (!work.maxmin.on_border(mesh.vertex_of(h)) || work.settled.marked(mesh, t) || !disagrees(mesh, h)) {
            continue;
        }
        const int site = mesh.site_of(h);
        if (const auto normal =
                normal_a_little_inside(work, mesh.face_of(t), mesh.site(site), way_to_centroid(mesh, h))) {
            mesh.set_normal(site, *normal);
        }
    }
}

}  // namespace mq::triangulate
