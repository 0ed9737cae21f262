// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/surface_patches.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "curve/injectivity/curved_crossings.h"
#include "curve/injectivity/solid_blocks.h"
#include "elements/product/reference_nodes.h"

namespace mq::curve {

using elements::ElementKind;
using elements::name_of;

namespace {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// A quadrilateral over the unit square moved by `shift`, of any order, by a formula.
void add_sheet(int order, const Vec3& shift, double bulge, std::vector<Vec3>& nodes, std::vector<SideBlock>& sides) {
    SideBlock side{ElementKind::Quadrilateral, order, elements::full_node_count(ElementKind::Quadrilateral, order), {}};
    for (const elements::GridPoint& p : elements::gmsh_nodes(ElementKind::Quadrilateral, order)) {
        const double x = static_cast<double>(p[0]) / order + shift.x();
        const double y = static_cast<double>(p[1]) / order + shift.y();
        side.nodes.push_back(static_cast<std::int32_t>(nodes.size()));
        nodes.emplace_back(x, y, shift.z() + bulge * x * x * (order > 1 ? 1.0 : 0.0));
    }
    sides.push_back(side);
}

Pairs crossing(const CurvedCrossings& found) {
    Pairs pairs;
    for (const CurvedCrossings::Crossing& c : found.crossing) {
        pairs.emplace_back(c.a, c.b);
    }
    return pairs;
}

TEST(SurfacePatches, SheetsOfQuadrilateralsSideBySideAreApart) {
    for (int order = 1; order <= elements::kMaxOrder; ++order) {
        std::vector<Vec3> nodes;
        std::vector<SideBlock> sides;
        for (const double height : {0.0, 0.01}) {
            for (const double x : {0.0, 1.0}) {
                for (const double y : {0.0, 1.0}) {
                    add_sheet(order, {x, y, height}, 0.25, nodes, sides);
                }
            }
        }
        const CurvedCrossings found = curved_crossings(SurfacePatches(nodes, sides));
        EXPECT_EQ(crossing(found), Pairs{}) << order;
        EXPECT_EQ(found.not_proven, Pairs{}) << order;
    }
}

TEST(SurfacePatches, APairOfQuadrilateralsThatCrossIsOne) {
    for (int order = 1; order <= elements::kMaxOrder; ++order) {
        std::vector<Vec3> nodes;
        std::vector<SideBlock> sides;
        add_sheet(order, Vec3::Zero(), 0.0, nodes, sides);
        const auto first = static_cast<std::ptrdiff_t>(nodes.size());
        add_sheet(order, Vec3::Zero(), 0.0, nodes, sides);
        for (auto p = nodes.begin() + first; p != nodes.end(); ++p) {
            *p = Vec3(p->x() - 0.1, 0.4, p->y() - 0.3);
        }
        EXPECT_EQ(crossing(curved_crossings(SurfacePatches(nodes, sides))), (Pairs{{0, 1}})) << order;
    }
}

TEST(SurfacePatches, OneThatCrossesItselfOnlyWhereItIsCurved) {
    // The sheet's middle nodes carry the end back through the beginning.
    std::vector<Vec3> nodes;
    std::vector<SideBlock> sides;
    add_sheet(4, Vec3::Zero(), 0.0, nodes, sides);
    for (Vec3& p : nodes) {
        const double t = 2.0 * p.x() - 1.0;  // a loop: x and z of the curve (t^2 - 1/3) (t, 1)
        p = Vec3(t * (t * t - 1.0 / 3.0), p.y(), t * t);
    }
    const CurvedCrossings found = curved_crossings(SurfacePatches(nodes, sides));
    ASSERT_EQ(crossing(found).size() + found.not_proven.size(), 1U);
}

TEST(SurfacePatches, SidesOfSeveralOrdersShareEqualEdges) {
    std::vector<Vec3> nodes;
    std::vector<SideBlock> sides;
    add_sheet(2, Vec3::Zero(), 0.25, nodes, sides);
    add_sheet(3, {1, 0, 0}, 0.25, nodes, sides);
    SideBlock triangle{ElementKind::Triangle, 2, 6, {}};  // below the edge on the line y = 0
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0, -1, 0), Vec3(1, 0, 0.25), Vec3(0, -0.5, 0), Vec3(0.5, -0.5, 0.1),
                          Vec3(0.5, 0, 0.0625)}) {
        triangle.nodes.push_back(static_cast<std::int32_t>(nodes.size()));
        nodes.push_back(p);
    }
    sides.push_back(triangle);
    const CurvedCrossings found = curved_crossings(SurfacePatches(nodes, sides));
    EXPECT_EQ(crossing(found), Pairs{});
    EXPECT_EQ(found.not_proven, Pairs{});
}

TEST(SurfacePatches, SolidsThatTouchOnPlanesTouchOnly) {
    for (const ElementKind kind : {ElementKind::Prism, ElementKind::Hexahedron}) {
        LooseSolids solids;
        solids.add(kind, Vec3::Zero());
        solids.add(kind, {0.25, 0.125, 1.0}, 0.5);
        const CurvedCrossings found = curved_crossings(SurfacePatches(solids.nodes, solids.sides()));
        EXPECT_EQ(crossing(found), Pairs{}) << name_of(kind);
        EXPECT_EQ(found.not_proven, Pairs{}) << name_of(kind);
        EXPECT_FALSE(found.touching.empty()) << name_of(kind);
    }
}

TEST(SurfacePatches, RefuseOtherSides) {
    const std::vector<Vec3> nodes(9, Vec3::Zero());
    EXPECT_THROW(SurfacePatches(nodes, {{ElementKind::Triangle, 1, 4, {0, 1, 2, 3}}}), InvalidInput);
    EXPECT_THROW(SurfacePatches(nodes, {{ElementKind::Quadrilateral, 6, 49, {}}}), InvalidInput);
    EXPECT_THROW(SurfacePatches(nodes, {{ElementKind::Hexahedron, 1, 8, {0, 1, 2, 3, 4, 5, 6, 7}}}), InvalidInput);
    EXPECT_THROW(SurfacePatches(nodes, {{ElementKind::Triangle, 1, 3, {0, 1, 9}}}), InvalidInput);
    EXPECT_EQ(curved_crossings(SurfacePatches(nodes, {})).compared, 0U);
}

}  // namespace
}  // namespace mq::curve
