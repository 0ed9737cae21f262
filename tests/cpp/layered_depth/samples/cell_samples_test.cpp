// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/cell_samples.h"

#include <gtest/gtest.h>

#include "layered_depth/reconstruction/quadric_error.h"

namespace mq::layered_depth {
namespace {

CellSample on_ray(int axis, int x, int y, int z, bool reconstructed = true) {
    CellSample s;
    s.at = {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)};
    s.axis = static_cast<std::uint8_t>(axis);
    s.reconstructed = reconstructed ? 1 : 0;
    return s;
}

CellCensus census_of(const std::vector<CellSample>& samples) {
    return census({{0, 0, 0}, 2}, samples.data(), samples.data() + samples.size());
}

TEST(CellCensus, CountsEdgesAndFaces) {
    const CellCensus one = census_of({on_ray(2, 0, 2, 1), on_ray(2, 1, 1, 0, false)});
    EXPECT_EQ(one.reconstructed, 1);
    EXPECT_EQ(one.retained, 1);
    EXPECT_FALSE(one.crowded_edge);
    EXPECT_EQ(one.faces_hit, 0b1001);  // x low, y high
    EXPECT_TRUE(census_of({on_ray(2, 0, 2, 1), on_ray(2, 0, 2, 0)}).crowded_edge);
    EXPECT_FALSE(census_of({on_ray(2, 0, 2, 1), on_ray(2, 0, 0, 1)}).crowded_edge);
    EXPECT_FALSE(census_of({on_ray(2, 0, 1, 1), on_ray(2, 0, 1, 0)}).crowded_edge);
}

/// The doubtful ones of the 256 patterns are those with a checkered face, two opposite corners alone, or no sign
/// change.
TEST(Topology, AllPatterns) {
    const CellCensus samples = census_of({on_ray(0, 0, 1, 1)});
    int simple = 0;
    for (int nodes = 0; nodes < 256; ++nodes) {
        const bool is = simple_topology(static_cast<std::uint8_t>(nodes), samples);
        EXPECT_EQ(is, simple_topology(static_cast<std::uint8_t>(255 - nodes), samples));
        simple += is ? 1 : 0;
    }
    // Classes of the cube's patterns that are simple: 1 corner 8, an edge 12, three on a face 24, a face 6, a corner
    // with its three neighbours 8, paths of four over three axes 24, and the complements of those below four.
    EXPECT_EQ(simple, 2 * (8 + 12 + 24) + 6 + 8 + 24);
}

TEST(Topology, FakeFacesAndCrowdedEdges) {
    EXPECT_TRUE(simple_topology(0x0f, census_of({on_ray(2, 0, 0, 1)})));
    // A sample in the face z high, whose nodes are all outside.
    EXPECT_FALSE(simple_topology(0x0f, census_of({on_ray(0, 0, 1, 2)})));
    EXPECT_TRUE(simple_topology(0x0f, census_of({on_ray(0, 0, 1, 1)})));
    EXPECT_FALSE(simple_topology(0x0f, census_of({on_ray(2, 0, 0, 1), on_ray(2, 0, 0, 0)})));
}

TEST(Sheets, EachSheetIsOne) {
    EXPECT_EQ(find_sheets(0).count, 0);
    EXPECT_EQ(find_sheets(255).count, 0);
    EXPECT_EQ(find_sheets(0b00000001).count, 1);
    EXPECT_EQ(find_sheets(0b00001111).count, 1);
    EXPECT_EQ(find_sheets(0b10000001).count, 2);  // two opposite nodes
    EXPECT_EQ(find_sheets(0b01101001).count, 4);  // every other node
    EXPECT_EQ(find_sheets(0b00001001).count, 2);  // a face's diagonal, separated inside
    EXPECT_EQ(find_sheets(0b00001001, 1U << 4).count, 1);
    for (int nodes = 0; nodes < 256; ++nodes) {
        const CellSheets sheets = find_sheets(static_cast<std::uint8_t>(nodes));
        EXPECT_LE(sheets.count, 4);
        std::array<int, 4> edges{};
        for (int e = 0; e < kCellEdges; ++e) {
            const int axis = e / 4, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
            const int low = (e & 1) * u + (e >> 1 & 1) * v, high = low + (1 << axis);
            const bool changes = ((nodes >> low ^ nodes >> high) & 1) != 0;
            ASSERT_EQ(changes, sheets.of_edge[e] != CellSheets::kNoSheet) << nodes << " edge " << e;
            if (changes) {
                ++edges[sheets.of_edge[e]];
            }
        }
        for (int k = 0; k < sheets.count; ++k) {
            EXPECT_GE(edges[k], 3);
        }
    }
}

/// A flip separates the sheet whose four edges lie in one face.
TEST(Sheets, FlippingUntiesKnots) {
    int knots = 0;
    for (int nodes = 0; nodes < 256; ++nodes) {
        const std::uint8_t knotted = knotted_faces(static_cast<std::uint8_t>(nodes));
        for (int f = 0; f < 6; ++f) {
            if ((knotted >> f & 1) != 0) {
                ++knots;
                const auto one_face = static_cast<std::uint8_t>(1 << f);
                EXPECT_GT(find_sheets(static_cast<std::uint8_t>(nodes), one_face).count,
                          find_sheets(static_cast<std::uint8_t>(nodes)).count);
            }
        }
    }
    EXPECT_GT(knots, 0);
}

TEST(Quadric, FindsCornersEdgesAndPlanes) {
    const Vec3 corner(0.3, 0.6, 0.2);
    Quadric quadric;
    quadric.add(corner + Vec3(0.0, 0.4, 0.1), Vec3(1, 0, 0));
    EXPECT_LT((quadric.minimiser(Vec3(0, 0, 0), Vec3(1, 1, 1)) - Vec3(0.3, 1.0, 0.3)).norm(), 1e-12);
    quadric.add(corner + Vec3(0.2, 0.0, 0.5), Vec3(0, 1, 0));
    EXPECT_LT((quadric.minimiser(Vec3(0, 0, 0), Vec3(1, 1, 1)) - Vec3(0.3, 0.6, 0.5)).norm(),
              1e-12);  // on the edge, at the mean height
    quadric.add(corner + Vec3(0.2, 0.1, 0.0), Vec3(0.6, 0.0, 0.8));
    EXPECT_LT((quadric.minimiser(Vec3(0, 0, 0), Vec3(1, 1, 1)) - (corner + Vec3(0, 0, 0.15))).norm(), 1e-9);
    EXPECT_EQ(quadric.count(), 3);
}

/// Nearly parallel planes do not move the minimiser far away.
TEST(Quadric, NearlyFlatDataStaysNear) {
    Quadric quadric;
    for (int k = 0; k < 4; ++k) {
        const double tilt = 0.02 * (k % 2 == 0 ? 1 : -1);
        quadric.add(Vec3(k % 2, k / 2, 0.5), Vec3(tilt, 0.0, 1.0).normalized());
    }
    EXPECT_LT((quadric.minimiser(Vec3(0, 0, 0), Vec3(1, 1, 1)) - Vec3(0.5, 0.5, 0.5)).norm(), 0.02);
}

}  // namespace
}  // namespace mq::layered_depth
