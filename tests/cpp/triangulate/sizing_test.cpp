// SPDX-License-Identifier: LGPL-2.1-or-later
#include <map>

#include "base/angle.h"
#include "triangulate/checks.h"
#include "triangulate/gradation.h"

/// Edges by the curvature, and how fast they grow.
namespace mq::triangulate {
namespace {

TEST(EdgesPerCircle, BoundTheTurnAlongEveryEdgeOfASphereAndACylinder) {
    for (const double edges : {12.0, 36.0}) {
        SCOPED_TRACE(edges);
        Options options;
        options.edges_per_circle = edges;
        const double longest = 2.0 * std::sin(M_PI / edges);  // of a chord, on a circle of radius 1
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
    Options options;
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

TEST(Growth, KeepsSizesOfNeighboursNearToEachOther) {
    std::map<double, std::size_t> triangles;
    for (const double growth : {0.0, 1.5, 1.2}) {
        SCOPED_TRACE(growth);
        Options options;
        options.growth = growth;
        options.local_sizes = {{0, 0, 0.05}};
        const Result result = mesh_of(geometry::make_box(4.0, 4.0, 4.0), options);
        expect_sound(result, 2, true);
        expect_angles(result, 25.0);
        triangles[growth] = result.mesh.triangles.size();
        if (!(growth > 0.0)) {
            continue;
        }
        Vec3 fine = Vec3::Zero();
        for (std::size_t v = 0; v < result.mesh.vertices.size(); ++v) {
            if (result.mesh.vertex_entity[v] == mesh::VertexEntity{0, 0}) {
                fine = result.mesh.vertices[v];
            }
        }
        for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
            const std::array<Vec3, 3> p = corners_of(result.mesh, t);
            for (int i = 0; i < 3; ++i) {
                const double far = std::max((p[i] - fine).norm(), (p[(i + 1) % 3] - fine).norm());
                // Along the edges the way is up to half as long again as straight through the box.
                EXPECT_LE((p[(i + 1) % 3] - p[i]).norm(), 1.6 * (0.05 + 1.75 * (growth - 1.0) * far));
            }
        }
    }
    EXPECT_GT(triangles[1.2], triangles[1.5]);
    EXPECT_GT(triangles[1.5], triangles[0.0]);
}

TEST(Growth, AndEdgesPerCircleOutOfRangeAreRefused) {
    for (const double edges : {-1.0, 2.0, std::nan("")}) {
        Options options;
        options.edges_per_circle = edges;
        EXPECT_THROW(options.validate(), InvalidInput) << edges;
    }
    for (const double growth : {-1.0, 0.5, 1.0, std::nan("")}) {
        Options options;
        options.growth = growth;
        EXPECT_THROW(options.validate(), InvalidInput) << growth;
    }
}

}  // namespace
}  // namespace mq::triangulate
