// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/cells.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "base/error.h"
#include "boolean/soups.h"

namespace mq::boolean {
namespace {

using soups::Arranged;

Cells cells_of(const Arranged& c) {
    return find_cells(c.soup, *c.arrangement, c.progress);
}

/// The windings of all operands, by cell.
std::vector<std::vector<std::int32_t>> all_windings(const Arranged& c, const Cells& cells) {
    std::vector<std::vector<std::int32_t>> result;
    for (const Windings& windings : cells.windings) {
        result.emplace_back(static_cast<std::size_t>(c.soup.operands), 0);
        for (const Winding& winding : windings) {
            EXPECT_NE(winding.times, 0);
            result.back()[static_cast<std::size_t>(winding.operand)] = winding.times;
        }
    }
    return result;
}

std::set<std::vector<std::int32_t>> windings_of(const Arranged& c) {
    const auto all = all_windings(c, cells_of(c));
    return {all.begin(), all.end()};
}

/// By component: space around a solid is a cell of each component.
TEST(Cells, OfTwoOverlappingCubesAreFour) {
    const Arranged c(soups::overlapping_cubes());
    const Cells cells = cells_of(c);
    EXPECT_EQ(windings_of(c), (std::set<std::vector<std::int32_t>>{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
    EXPECT_EQ(cells.patches, 4u);
    EXPECT_GE(cells.curve_edges, 6u);
}

TEST(Cells, WindingsDifferByTheOperandOfTheFaceBetween) {
    const Arranged c(
        {solids::sphere(Vec3(0, 0, 0), 1.0, 6, 0.1, 3), solids::sphere(Vec3(0.5, 0.3, 0.2), 1.0, 7, 0.1, 4)});
    const Cells cells = cells_of(c);
    const auto windings = all_windings(c, cells);
    ASSERT_EQ(cells.front.size(), c.arrangement->faces.size());
    for (std::size_t f = 0; f < cells.front.size(); ++f) {
        const std::int32_t own = c.soup.source[static_cast<std::size_t>(c.arrangement->faces[f].source)].operand;
        for (std::int32_t operand = 0; operand < 2; ++operand) {
            const auto at = [&](std::int32_t cell) {
                return windings[static_cast<std::size_t>(cell)][static_cast<std::size_t>(operand)];
            };
            EXPECT_EQ(at(cells.back[f]) - at(cells.front[f]), operand == own ? 1 : 0);
        }
    }
}

TEST(Cells, NestedSolidsAreWoundTwice) {
    const Arranged c({solids::box(Vec3(0, 0, 0), Vec3(4, 4, 4)), solids::box(Vec3(1, 1, 1), Vec3(2, 2, 2))});
    EXPECT_EQ(windings_of(c), (std::set<std::vector<std::int32_t>>{{0, 0}, {1, 0}, {1, 1}}));
}

TEST(Cells, ASolidInsideOutIsWoundBackwards) {
    mesh::TriangleMesh inward = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    for (Triangle& t : inward.triangles) {
        std::swap(t[1], t[2]);
    }
    const Arranged c({inward});
    EXPECT_EQ(windings_of(c), (std::set<std::vector<std::int32_t>>{{0}, {-1}}));
}

TEST(Cells, ASurfaceWithABorderBoundsNone) {
    mesh::TriangleMesh open = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    open.triangles.pop_back();
    const Arranged c({open});
    EXPECT_THROW(cells_of(c), TopologyError);
}

}  // namespace
}  // namespace mq::boolean
