// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/common_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "curve/injectivity/solid_blocks.h"

namespace mq::curve {

using elements::ElementKind;
using elements::gmsh_nodes;
using elements::GridPoint;

namespace {

std::vector<CommonPoint> of_two(ElementKind first, ElementKind second, const Vec3& shift) {
    LooseSolids solids;
    solids.add(first, Vec3::Zero());
    solids.add(second, shift);
    return common_points(solids.nodes, solids.blocks, solids.bodies());
}

TEST(CommonPoints, OfEachTwoKinds) {
    for (const ElementKind first : kSolidKinds) {
        for (const ElementKind second : kSolidKinds) {
            const std::vector<CommonPoint> found = of_two(first, second, {0.1, 0.05, 0.1});
            ASSERT_EQ(found.size(), 1U) << elements::name_of(first) << ' ' << elements::name_of(second);
            EXPECT_EQ(found[0].elements, (std::array<std::int32_t, 2>{0, 1}));
            EXPECT_GT((found[0].point - Vec3(0.1, 0.05, 0.1)).minCoeff(), -1.0);
            EXPECT_TRUE(of_two(first, second, {2.1, 0.05, 0.1}).empty());
        }
    }
}

TEST(CommonPoints, TellTouchingFromOverlappingByAHair) {
    for (const Vec3& along : {Vec3(1, 0, 0), Vec3(1, 0.3, 0.2), Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
        EXPECT_TRUE(of_two(ElementKind::Hexahedron, ElementKind::Hexahedron, along).empty());
        const Vec3 nearer = along - 1e-7 * Vec3(1, along.y() == 1, along.z() == 1);
        EXPECT_EQ(of_two(ElementKind::Hexahedron, ElementKind::Hexahedron, nearer).size(), 1U) << along;
    }
    EXPECT_EQ(of_two(ElementKind::Hexahedron, ElementKind::Hexahedron, Vec3::Zero()).size(), 1U) << "the same place";
}

TEST(CommonPoints, AreOneForTwoBodies) {
    LooseSolids solids;
    for (int i = 0; i < 4; ++i) {
        solids.add(ElementKind::Hexahedron, Vec3(0.25 * i, 0, 0));
    }
    EXPECT_EQ(common_points(solids.nodes, solids.blocks, {0, 0, 2, 2}).size(), 1U);
    EXPECT_TRUE(common_points(solids.nodes, solids.blocks, {0, 0, 0, 0}).empty());
    EXPECT_EQ(common_points(solids.nodes, solids.blocks, {0, 1, 2, 3}).size(), 6U);
}

TEST(CommonPoints, FindABulgeIntoANeighbourOfTheSameRim) {
    // Sides with the same corners and edges: nothing pierces anything.
    for (const double bulge : {0.25, 1e-5, -0.25}) {
        LooseSolids solids;
        solids.add(ElementKind::Hexahedron, Vec3::Zero());
        solids.add(ElementKind::Hexahedron, {1, 0, 0});
        SolidBlock& second = solids.blocks[1];
        second.order = 2;
        second.nodes.clear();
        for (const GridPoint& p : gmsh_nodes(ElementKind::Hexahedron, 2)) {
            const bool middle = p[0] == 0 && p[1] == 1 && p[2] == 1;
            second.nodes.push_back(static_cast<std::int32_t>(solids.nodes.size()));
            solids.nodes.emplace_back(1.0 + 0.5 * p[0] - (middle ? bulge : 0.0), 0.5 * p[1], 0.5 * p[2]);
        }
        second.nodes_per_element = 27;
        second.faces.clear();
        const std::vector<GridPoint> all = gmsh_nodes(ElementKind::Hexahedron, 2);
        for (const std::vector<std::size_t>& corners : elements::sides_of(ElementKind::Hexahedron).faces) {
            SolidBlock::Face face{ElementKind::Quadrilateral, 2, {}};
            for (const GridPoint& p : gmsh_nodes(ElementKind::Quadrilateral, 2)) {
                GridPoint wanted{};
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto at = [&](std::size_t c) { return all[corners[c]][k]; };
                    wanted[k] = at(0) + p[0] * (at(1) - at(0)) / 2 + p[1] * (at(3) - at(0)) / 2;
                }
                face.nodes.push_back(
                    static_cast<std::int32_t>(std::find(all.begin(), all.end(), wanted) - all.begin()));
            }
            second.faces.push_back(face);
        }
        const std::vector<CommonPoint> found = common_points(solids.nodes, solids.blocks, solids.bodies());
        EXPECT_EQ(found.size(), bulge > 0.0 ? 1U : 0U) << bulge;
    }
}

TEST(CommonPoints, RefuseWhatDoesNotFit) {
    LooseSolids solids;
    solids.add(ElementKind::Hexahedron, Vec3::Zero());
    EXPECT_THROW(common_points(solids.nodes, solids.blocks, {}), InvalidInput);
    solids.nodes[3].x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(common_points(solids.nodes, solids.blocks, {0}), InvalidInput);
    solids.blocks[0].kind = ElementKind::Triangle;
    EXPECT_THROW(common_points(solids.nodes, solids.blocks, {0}), InvalidInput);
}

}  // namespace
}  // namespace mq::curve
