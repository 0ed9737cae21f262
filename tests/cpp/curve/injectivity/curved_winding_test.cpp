// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/curved_winding.h"

#include <gtest/gtest.h>

#include "curve/injectivity/solid_blocks.h"

namespace mq::curve {

using elements::ElementKind;
using elements::name_of;

namespace {

std::optional<int> turns_about(const Vec3& point, const std::vector<Vec3>& nodes, const std::vector<SideBlock>& sides) {
    const SurfacePatches patches(nodes, sides);
    std::vector<std::vector<Vec3>> control;
    for (std::size_t t = 0; t < patches.size(); ++t) {
        control.push_back(patches.control(static_cast<std::int32_t>(t)));
    }
    return curved_winding(patches.lattice(), control, point - patches.middle(), 1e-9);
}

TEST(CurvedWinding, IsOneWithinAndZeroBeside) {
    for (const ElementKind kind : kSolidKinds) {
        LooseSolids solids;
        solids.add(kind, Vec3::Zero());
        EXPECT_EQ(turns_about({0.2, 0.2, 0.3}, solids.nodes, solids.sides()), 1) << name_of(kind);
        EXPECT_EQ(turns_about({1.2, 0.2, 0.3}, solids.nodes, solids.sides()), 0) << name_of(kind);
        EXPECT_EQ(turns_about({0.2, 0.2, 1e-4}, solids.nodes, solids.sides()), 1) << name_of(kind);
    }
}

TEST(CurvedWinding, IsNotSaidOnTheSurfaceOrWhereThatIsOpen) {
    LooseSolids solids;
    solids.add(ElementKind::Hexahedron, Vec3::Zero());
    EXPECT_EQ(turns_about({0.5, 0.25, 0.0}, solids.nodes, solids.sides()), std::nullopt);
    std::vector<SideBlock> open = solids.sides();
    open.pop_back();
    EXPECT_EQ(turns_about({0.5, 0.5, 0.5}, solids.nodes, open), std::nullopt);
}

TEST(CurvedWinding, CountsCurvedSides) {
    // A face that bulges by half an edge: a point beside the straight hexahedron is inside, and one just beyond is not.
    LooseSolids solids;
    solids.add(ElementKind::Hexahedron, Vec3::Zero());
    std::vector<SideBlock> sides = solids.sides();
    SideBlock& top = sides.back();  // between the nodes 4, 5, 6 and 7
    ASSERT_EQ(top.nodes.front(), 4);
    top = {ElementKind::Quadrilateral, 2, 9, {4, 5, 6, 7}};
    for (const Vec3& p : {Vec3(0.5, 0, 1), Vec3(1, 0.5, 1), Vec3(0.5, 1, 1), Vec3(0, 0.5, 1), Vec3(0.5, 0.5, 1.5)}) {
        top.nodes.push_back(static_cast<std::int32_t>(solids.nodes.size()));
        solids.nodes.push_back(p);
    }
    EXPECT_EQ(turns_about({0.5, 0.5, 1.45}, solids.nodes, sides), 1);
    EXPECT_EQ(turns_about({0.5, 0.5, 1.55}, solids.nodes, sides), 0);
    EXPECT_EQ(turns_about({0.1, 0.1, 1.45}, solids.nodes, sides), 0);
}

}  // namespace
}  // namespace mq::curve
