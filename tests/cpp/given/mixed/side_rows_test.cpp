// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/side_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "given/mixed/blocks.h"

namespace mq::given {
namespace {

TEST(SideRows, FacesFollowOneAnotherFromWallToWallOrToTheTop) {
    const MixedMesh mesh = hexahedra(1, 1, 3, [](double x, double y, double z) { return Vec3(x, y, 3 * z * z); });
    const auto level = [&](double height) {
        return [&mesh, height](const std::vector<std::int32_t>& side) {
            return std::all_of(side.begin(), side.end(),
                               [&](std::int32_t v) { return mesh.nodes[static_cast<std::size_t>(v)].z() == height; });
        };
    };
    const std::vector<SideRow> open = rows_of_faces(mesh, level(0.0));
    ASSERT_EQ(open.size(), 1u);
    EXPECT_EQ(open[0].sides.size(), 4u);
    EXPECT_FALSE(open[0].ends_on_cad);
    EXPECT_NEAR(open[0].height, 3.0, 1e-12);
    for (std::size_t k = 0; k < 4; ++k) {
        for (const double share : open[0].fractions[k]) {
            EXPECT_NEAR(share, static_cast<double>(k * k) / 9.0, 1e-12);
        }
    }
    const auto both = [&](const std::vector<std::int32_t>& side) { return level(0.0)(side) || level(3.0)(side); };
    const std::vector<SideRow> closed = rows_of_faces(mesh, both);
    ASSERT_EQ(closed.size(), 1u);
    EXPECT_TRUE(closed[0].ends_on_cad);
}

TEST(SideRows, EdgesEndWhereQuadrilateralsDo) {
    // Three quadrilaterals in a row, of which the second and third meet in edge (4, 5).
    const std::vector<Vec3> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                  {0, 3, 0}, {1, 3, 0}, {0, 6, 0}, {1, 6, 0}};
    const std::vector<RowQuadrilateral> all{{{0, 1, 3, 2}, {0, -1}}, {{3, 2, 4, 5}, {1, -1}}, {{4, 5, 7, 6}, {2, -1}}};
    const auto wall = [](const std::vector<std::int32_t>& side) { return side[0] < 2 && side[1] < 2; };
    const std::vector<SideRow> rows = rows_of_edges(all, nodes, wall);
    ASSERT_EQ(rows.size(), 1u);
    const std::vector<std::vector<std::int32_t>> wanted{{0, 1}, {2, 3}, {4, 5}, {6, 7}};
    EXPECT_EQ(rows[0].sides, wanted);
    EXPECT_NEAR(rows[0].fractions[2][0], 0.5, 1e-12);
    std::vector<RowQuadrilateral> same = all;
    same[2].elements = {1, -1};  // of one element with the second: the row does not go round its corner
    EXPECT_EQ(rows_of_edges(same, nodes, wall)[0].sides.size(), 3u);
}

}  // namespace
}  // namespace mq::given
