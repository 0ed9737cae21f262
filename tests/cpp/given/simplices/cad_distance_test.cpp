// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/simplices/cad_distance.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "curve/checks.h"
#include "geometry/analytic/analytic_model.h"

namespace mq::given {
namespace {

TEST(CadDistance, OfAWholeMeshIsThatOfItsTriangles) {
    geometry::Engine engine;
    for (int order = 1; order <= 4; ++order) {
        const auto model = geometry::make_sphere(1.0);
        const curve::CurvedMesh mesh = curve::curved(model, curve::of_order(order));
        const CadDistances found = cad_distances(engine, model, mesh.nodes, order, mesh.triangles);
        ASSERT_EQ(found.of_face.size(), 1u);
        EXPECT_LT(found.of_face[0], 1.2 * mesh.report.max_deviation + 1e-12) << order;
        EXPECT_GT(found.of_face[0], 0.5 * mesh.report.max_deviation) << order;
        EXPECT_LT(found.spacing, 0.3);
        EXPECT_GT(found.samples, 1000u);
    }
}

TEST(CadDistance, OfAHoleIsItsDepth) {
    geometry::Engine engine;
    const auto model = geometry::make_sphere(1.0);
    curve::CurvedMesh mesh = curve::curved(model, curve::of_order(2));
    std::vector<std::int32_t> kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 6) {
        const Vec3& corner = mesh.nodes[static_cast<std::size_t>(mesh.triangles[t])];
        if (corner.x() < 0.5) {
            kept.insert(kept.end(), mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t),
                        mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t + 6));
        }
    }
    const CadDistances found = cad_distances(engine, model, mesh.nodes, 2, kept);
    EXPECT_GT(found.of_face[0], 0.4);
    EXPECT_GT(found.farthest.x(), 0.9);
}

TEST(CadDistance, OfNoTrianglesIsRefused) {
    geometry::Engine engine;
    EXPECT_THROW(cad_distances(engine, geometry::make_sphere(1.0), {}, 2, {}), InvalidInput);
}

}  // namespace
}  // namespace mq::given
