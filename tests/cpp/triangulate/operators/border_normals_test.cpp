// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/border_normals.h"

#include <cmath>

#include "geometry/analytic/analytic_model.h"
#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

TEST(BorderNormal, TheWayAcrossIsTheHeightOfTheTriangle) {
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        const ClassifiedMesh& mesh = pipeline.surface;
        for (int h = 0; h < mesh.half_edge_count(); ++h) {
            const Vec3 side = mesh.point_of(ClassifiedMesh::next(h)) - mesh.point_of(h);
            const Vec3 other = mesh.point_of(ClassifiedMesh::prev(h)) - mesh.point_of(h);
            const Vec3 way = inward_step(mesh, h).step;
            EXPECT_NEAR(way.dot(side) / side.norm(), 0.0, 1e-9 * other.norm());
            EXPECT_NEAR(way.norm() * side.norm(), side.cross(other).norm(), 1e-9 * side.norm() * other.norm());
        }
    }
}

TEST(BorderNormal, IsTakenFromInsideWhereTheSurfaceTurnsByMoreThan60DegreesUnseen) {
    Pipeline pipeline(geometry::make_cylinder(2.0, 5.0));
    const auto at = [&](double degrees) {
        const double u = degrees * M_PI / 180.0;
        const Vec3 normal(std::cos(u), std::sin(u), 0.0);
        return ClassifiedMesh::VertexUse{-1, Vec2(u, 2.0), normal,
                                         2.0 * normal + Vec3(0.0, 0.0, 2.0) - pipeline.grid.origin()};
    };
    int lateral = 0;
    while (std::abs(pipeline.session.ask(geometry::Query::face_point(lateral, 0.3, 2.0)).normal.z()) > 0.5) {
        ++lateral;
    }
    const ClassifiedMesh::VertexUse from = at(0.0);
    const auto way_to = [&](double degrees) {
        return InwardStep{at(degrees).point - from.point, at(degrees).uv - from.uv};
    };
    const auto normal = [&](const ClassifiedMesh::VertexUse& site, double unseen, double degrees) {
        pipeline.work.unseen = unseen;
        return interior_normal(pipeline.work, lateral, site, way_to(degrees));
    };
    const auto turned = normal(from, 10.0, 150.0);  // half of the step: the middle of the chord, at 75 degrees
    ASSERT_TRUE(turned);
    EXPECT_NEAR((*turned - at(75.0).normal).norm(), 0.0, 1e-9);
    EXPECT_FALSE(normal(from, 10.0, 100.0));  // deviates by 50 degrees
    EXPECT_FALSE(normal(from, 0.1, 150.0));   // deviates by a few degrees
    EXPECT_FALSE(normal(from, 10.0, 0.0));    // the step has no length
    ClassifiedMesh::VertexUse apex = from;
    apex.normal = Vec3::Zero();
    EXPECT_FALSE(normal(apex, 10.0, 150.0));
}

TEST(BorderNormal, OnOrdinaryPartsAllStayAsTheyAre) {
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        pipeline.work.unseen = 1e-3 * part.model->topology().box.largest_side();
        const ClassifiedMesh before = pipeline.surface;
        use_interior_normals(pipeline.work);
        for (int s = 0; s < before.site_count(); ++s) {
            EXPECT_EQ(before.site(s).normal, pipeline.surface.site(s).normal);
        }
    }
}

/// Simulates a surface whose normal reverses beside a single site.
TEST(BorderNormal, FirstSitesFollowTheirTriangles) {
    Pipeline pipeline(geometry::make_box(3.0, 4.0, 5.0));
    pipeline.work.unseen = 1e-3;
    ClassifiedMesh& mesh = pipeline.surface;
    for (int s = 0; s < mesh.site_count(); ++s) {
        const Vec3 normal = mesh.site(s).normal;
        mesh.set_normal(s, -normal);
        use_interior_normals(pipeline.work);
        EXPECT_NEAR((mesh.site(s).normal - normal).norm(), 0.0, 1e-12);
    }
}

}  // namespace
}  // namespace mq::triangulate
