// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curve/curve.h"
#include "geometry/creased_shapes.h"
#include "geometry/occt/shape_model.h"
#include "triangulate/triangulate.h"

namespace mq::curve {
namespace {

/// Creases are followed, and the result refers to the shape's own entities.
TEST(CreasedParts, AreCurvedByTheirPieces) {
    for (const TopoDS_Shape& shape : {geometry::block_with_one_side(), geometry::wing_with_flat_ends()}) {
        const auto model = geometry::make_shape_model(shape, nullptr, geometry::Creases::Cut);
        geometry::Engine engine(geometry::Engine::Mode::Direct);
        const triangulate::Result straight = triangulate::triangulate(engine, model, {});
        for (int order = 1; order <= 4; ++order) {
            CurveOptions options;
            options.order = order;
            const CurvedMesh mesh = curve(engine, model, straight.mesh, options);
            EXPECT_EQ(mesh.report.invalid, 0U);
            EXPECT_LT(mesh.report.max_deviation, 0.1);
            const geometry::Topology& topology = model->topology();
            for (const std::int32_t face : mesh.triangle_face) {
                EXPECT_LT(static_cast<std::size_t>(face), topology.own_count(2));
            }
            for (const std::int32_t edge : mesh.edge_entity) {
                EXPECT_LT(static_cast<std::size_t>(edge), topology.own_count(1));
            }
            for (const mesh::VertexEntity& entity : mesh.node_entity) {
                EXPECT_LT(static_cast<std::size_t>(entity[1]), topology.own_count(entity[0]));
            }
            EXPECT_EQ(mesh.edges.size(), mesh.edge_entity.size() * static_cast<std::size_t>(mesh.nodes_per_edge()));
        }
    }
}

}  // namespace
}  // namespace mq::curve
