// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/curve_mixed.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "elements/product/check_elements.h"
#include "geometry/occt/shape_model.h"
#include "given/mixed/blocks.h"

namespace mq::given {
namespace {

CurvedMixedMesh curved(const TopoDS_Shape& shape, const MixedMesh& given, int order) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    curve::CurveOptions options;
    options.order = order;
    return curve_mixed(engine, geometry::make_shape_model(shape), given, options);
}

/// Half of the wall of a pipe from radius 1 to 2 and of height 1, thinnest inside.
TopoDS_Shape half_pipe() {
    const TopoDS_Shape outer = BRepPrimAPI_MakeCylinder(2.0, 1.0, M_PI).Shape();
    return BRepAlgoAPI_Cut(outer, BRepPrimAPI_MakeCylinder(1.0, 1.0).Shape()).Shape();
}

MixedMesh in_half_pipe(int around, int layers, double power) {
    return hexahedra(layers, around, 2, [&](double x, double y, double z) {
        const double r = 1.0 + std::pow(x, power);
        return Vec3(r * std::cos(M_PI * y), r * std::sin(M_PI * y), z);
    });
}

TEST(CurveMixed, ThinLayersFollowTheirWall) {
    const MixedMesh given = in_half_pipe(3, 5, 4.0);  // the first layer is 1/625 thick, its wall bends by 0.13
    for (int order = 2; order <= 4; ++order) {
        const CurvedMixedMesh mesh = curved(half_pipe(), given, order);
        EXPECT_GE(mesh.report.invalid_before, 6u) << order;
        EXPECT_EQ(mesh.report.invalid, 0u) << order;
        EXPECT_TRUE(mesh.moved_nodes.empty()) << order;
        EXPECT_NEAR(mesh.report.volume, 1.5 * M_PI, 0.02 * std::pow(0.2, order - 2)) << order;
        for (const ElementBlock& block : mesh.blocks) {
            const elements::ElementVerdicts found = elements::check_elements(
                block.kind, order, mesh.nodes, block.nodes, elements::full_node_count(block.kind, order));
            for (const std::uint8_t verdict : found.verdict) {
                EXPECT_EQ(verdict, static_cast<std::uint8_t>(elements::Verdict::Valid))
                    << elements::name_of(block.kind) << " " << order;
            }
        }
        for (std::size_t v = 0; v < mesh.given_node.size(); ++v) {
            EXPECT_EQ(mesh.nodes[v], given.nodes[static_cast<std::size_t>(mesh.given_node[v])]);
        }
    }
}

TEST(CurveMixed, StraighteningLeavesWhatItDoesNotHelp) {
    // An inner corner beyond its neighbour: hexahedra that no curving and no straightening makes valid.
    MixedMesh given = in_half_pipe(4, 3, 1.0);
    const auto inner = std::find_if(given.nodes.begin(), given.nodes.end(), [](const Vec3& p) {
        return std::abs(p.norm() - std::hypot(4.0 / 3.0, 0.5)) < 1e-6 && std::abs(p.x()) < 1e-6;
    });
    ASSERT_NE(inner, given.nodes.end());
    inner->y() = 1.8;
    const auto run = [&](bool straighten) {
        geometry::Engine engine(geometry::Engine::Mode::Direct);
        curve::CurveOptions options;
        options.order = 2;
        options.straighten = straighten;
        return curve_mixed(engine, geometry::make_shape_model(half_pipe()), given, options);
    };
    const CurvedMixedMesh left = run(false);
    const CurvedMixedMesh tried = run(true);
    EXPECT_GT(left.report.invalid, 0u);
    EXPECT_EQ(tried.report.invalid, left.report.invalid);
    EXPECT_TRUE(tried.report.straightened.empty());
    EXPECT_EQ(tried.nodes, left.nodes);
}

TEST(CurveMixed, LayersArePiecesOfOneMacroElement) {
    const CurvedMixedMesh mesh = curved(half_pipe(), in_half_pipe(4, 3, 2.0), 3);
    // All cylinders between follow the walls: each node lies at the share of the radius that its layer has.
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const double r = std::hypot(mesh.nodes[n].x(), mesh.nodes[n].y());
        EXPECT_GT(r, 1.0 - 1e-6);
        EXPECT_LT(r, 2.0 + 1e-6);
    }
    EXPECT_GT(mesh.report.min_distortion, 0.5);
}

TEST(CurveMixed, FlatShapesStayStraight) {
    const MixedMesh given = cubes(2, 2, 2);
    const CurvedMixedMesh mesh = curved(BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape(), given, 3);
    EXPECT_EQ(mesh.report.invalid, 0u);
    EXPECT_NEAR(mesh.report.min_distortion, 1.0, 0.02);
    EXPECT_NEAR(mesh.report.volume, 8.0, 1e-9);
    EXPECT_EQ(mesh.nodes.size(), 343u);
    ASSERT_EQ(mesh.blocks.size(), 2u);
    EXPECT_EQ(mesh.blocks[1].entity.size(), 24u);
    EXPECT_EQ(mesh.edge_entity.size(), 24u);
}

TEST(CurveMixed, OrdersAndMeshesThatAreNotPossibleAreRefused) {
    EXPECT_THROW(curved(half_pipe(), in_half_pipe(3, 2, 1.0), 5), InvalidInput);
    EXPECT_THROW(curved(BRepPrimAPI_MakeBox(20.0, 20.0, 20.0).Shape(), cubes(2, 2, 2), 2), InvalidInput);
}

}  // namespace
}  // namespace mq::given
