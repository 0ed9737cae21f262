// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/gradation.h"

#include <map>

#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

TEST(Growth, KeepsSizesOfNeighboursNearToEachOther) {
    std::map<double, std::size_t> triangles;
    for (const double growth : {0.0, 1.5, 1.2}) {
        SCOPED_TRACE(growth);
        TriangulateOptions options;
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
                // Paths along the edges are up to half as long again as straight ones through the box.
                EXPECT_LE((p[(i + 1) % 3] - p[i]).norm(), 1.6 * (0.05 + 1.75 * (growth - 1.0) * far));
            }
        }
    }
    EXPECT_GT(triangles[1.2], triangles[1.5]);
    EXPECT_GT(triangles[1.5], triangles[0.0]);
}

}  // namespace
}  // namespace mq::triangulate
