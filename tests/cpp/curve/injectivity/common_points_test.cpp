// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/common_points.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "curve/injectivity/solid_blocks.h"

namespace mq::curve {
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
            ASSERT_EQ(found.size(), 1U) << name_of(first) << ' ' << name_of(second);
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
