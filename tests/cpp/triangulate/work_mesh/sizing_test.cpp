// SPDX-License-Identifier: LGPL-2.1-or-later
#include <map>

#include "base/angle.h"
#include "triangulate/checks.h"
#include "triangulate/work_mesh/gradation.h"

/// Lengths of edges by the curvature, and their growth.
namespace mq::triangulate {
namespace {

TEST(EdgesPerCircle, BoundTheTurnAlongEveryEdgeOfASphereAndACylinder) {
    for (const double edges : {12.0, 36.0}) {
        SCOPED_TRACE(edges);
        TriangulateOptions options;
        options.edges_per_circle = edges;
        const double longest = 2.0 * std::sin(M_PI / edges);  // length of a chord on a circle of radius 1
        const Result sphere = mesh_of(geometry::make_sphere(2.0), options);
        expect_angles(sphere, 25.0);
        for (std::size_t t = 0; t < sphere.mesh.triangles.size(); ++t) {
            const std::array<Vec3, 3> p = corners_of(sphere.mesh, t);
            for (int i = 0; i < 3; ++i) {
                EXPECT_LE((p[(i + 1) % 3] - p[i]).norm(), 2.0 * longest + 1e-5);
            }
        }
        const Result cylinder = mesh_of(geometry::make_cylinder(2.0, 50.0), options);
        expect_angles(cylinder, 25.0);
        double around = 0.0;
        double along = 0.0;
        for (std::size_t t = 0; t < cylinder.mesh.triangles.size(); ++t) {
            const std::array<Vec3, 3> p = corners_of(cylinder.mesh, t);
            for (int i = 0; i < 3 && cylinder.mesh.triangle_face[t] == 0; ++i) {
                const Vec3 way = p[(i + 1) % 3] - p[i];
                around = std::max(around, way.head<2>().norm());
                along = std::max(along, std::abs(way.z()));
            }
        }
        EXPECT_LE(around, 2.0 * longest + 1e-5);
        EXPECT_GT(along, 2.0 * longest) << "no bound where the surface is straight";
    }
}

TEST(EdgesPerCircle, BoundTheRimOfAFlatFace) {
    TriangulateOptions options;
    options.edges_per_circle = 40.0;
    const Result result = mesh_of(geometry::make_shape_model(geometry::holed_plate()), options);
    std::size_t on_hole = 0;
    for (std::size_t v = 0; v < result.mesh.vertices.size(); ++v) {
        const Vec3 p = result.mesh.vertices[v] + result.mesh.origin;
        on_hole += std::abs(std::hypot(p.x() - 1.0, p.y() - 0.5) - 2.0) < 1e-5 && std::abs(p.z()) < 1e-5 ? 1 : 0;
    }
    EXPECT_GE(on_hole, 40u);
    EXPECT_LT(on_hole, 100u);
}

TEST(Growth, AndEdgesPerCircleOutOfRangeAreRefused) {
    for (const double edges : {-1.0, 2.0, std::nan("")}) {
        TriangulateOptions options;
        options.edges_per_circle = edges;
        EXPECT_THROW(options.validate(), InvalidInput) << edges;
    }
    for (const double growth : {-1.0, 0.5, 1.0, std::nan("")}) {
        TriangulateOptions options;
        options.growth = growth;
        EXPECT_THROW(options.validate(), InvalidInput) << growth;
    }
}

}  // namespace
}  // namespace mq::triangulate
