// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/border_normals.h"

#include <algorithm>

#include "triangulate/operators/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/surface_alignment.h"

namespace mq::triangulate {

namespace {

using geometry::Query;

// Whether the corner's normal deviates by almost a right angle from that of the triangle or of another corner.
bool disagrees(const ClassifiedMesh& mesh, int h) {
    const int next = ClassifiedMesh::next(h);
    const int prev = ClassifiedMesh::prev(h);
    const Vec3& normal = mesh.site(mesh.site_of(h)).normal;
    const Vec3 area = doubled_area(mesh, ClassifiedMesh::triangle_of(h));
    return normal.dot(area) < kAlignedAtLast * area.norm() ||
           normal.dot(mesh.site(mesh.site_of(next)).normal) < kAlignedAtLast ||
           normal.dot(mesh.site(mesh.site_of(prev)).normal) < kAlignedAtLast;
}

InwardStep way_to_centroid(const ClassifiedMesh& mesh, int h) {
    const ClassifiedMesh::VertexUse& a = mesh.site(mesh.site_of(h));
    const ClassifiedMesh::VertexUse& b = mesh.site(mesh.site_of(ClassifiedMesh::next(h)));
    const ClassifiedMesh::VertexUse& c = mesh.site(mesh.site_of(ClassifiedMesh::prev(h)));
    return {(b.point + c.point - 2.0 * a.point) / 3.0, (b.uv + c.uv - 2.0 * a.uv) / 3.0};
}

}  // namespace

InwardStep inward_step(const ClassifiedMesh& mesh, int half_edge) {
    const ClassifiedMesh::VertexUse& a = mesh.site(mesh.site_of(half_edge));
    const ClassifiedMesh::VertexUse& b = mesh.site(mesh.site_of(ClassifiedMesh::next(half_edge)));
    const ClassifiedMesh::VertexUse& c = mesh.site(mesh.site_of(ClassifiedMesh::prev(half_edge)));
    const Vec3 side = b.point - a.point;
    const double at = side.dot(c.point - a.point) / side.squaredNorm();
    return {c.point - a.point - at * side, c.uv - a.uv - at * (b.uv - a.uv)};
}

std::optional<Vec3> interior_normal(const Workspace& work, int face, const ClassifiedMesh::VertexUse& site,
                                    const InwardStep& way) {
    const double length = way.step.norm();
    if (!(length > 0.0) || !(site.normal.squaredNorm() > 0.0)) {
        return std::nullopt;
    }
    const double part = std::min(OperatorTuning::kPartOfWay, work.unseen / length);
    const Vec2 uv = site.uv + part * way.uv_step;
    const geometry::Answer there =
        work.session.ask(Query::face_nearest(face, work.grid.to_shape(site.point + part * way.step), uv.x(), uv.y()));
    const bool turned = there.found() && there.normal.squaredNorm() > 0.0 && there.normal.dot(site.normal) < kAligned;
    return turned ? std::optional<Vec3>(there.normal) : std::nullopt;
}

void use_interior_normals(Workspace& work) {
    ClassifiedMesh& mesh = work.mesh;
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        const int t = ClassifiedMesh::triangle_of(h);
        if (!work.maxmin.on_border(mesh.vertex_of(h)) || work.settled.marked(mesh, t) || !disagrees(mesh, h)) {
            continue;
        }
        const int site = mesh.site_of(h);
        if (const auto normal = interior_normal(work, mesh.face_of(t), mesh.site(site), way_to_centroid(mesh, h))) {
            mesh.set_normal(site, *normal);
        }
    }
}

}  // namespace mq::triangulate
