// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/rounded_surface.h"

#include <gtest/gtest.h>

namespace mq::boolean {
namespace {

/// A flat pillow of two triangles and a copy of a corner in the same place; the third triangle has no area.
ResultMesh pillow() {
    ResultMesh draft;
    draft.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0.5, 0, 0}};
    draft.made = {kFromOperand, kFromOperand, kFromOperand, kConstructed, kConstructed};
    draft.triangles = {{0, 1, 2}, {3, 2, 1}, {0, 1, 4}};
    draft.source.resize(3);
    draft.from = {0, 1, 2};
    draft.displacement = {1e-4, 0, 0};
    return draft;
}

TEST(RoundedSurface, VerticesInOnePlaceAreOne) {
    const RoundedSurface surface(pillow());
    EXPECT_EQ(surface.triangle(1), (Triangle{0, 2, 1}));
    EXPECT_TRUE(surface.edited());
    EXPECT_TRUE(surface.made(0));
    EXPECT_FALSE(surface.made(1));
    EXPECT_EQ(surface.flat(), std::vector<std::int32_t>{2});
}

TEST(RoundedSurface, ReplacedTrianglesAreFoundByPlaceNoLonger) {
    RoundedSurface surface(pillow());
    surface.index_added();
    surface.replace(0, {{0, 4, 2}, {4, 1, 2}, {1, 1, 2}}, 1e-3);
    surface.index_added();
    EXPECT_FALSE(surface.alive(0));
    EXPECT_EQ(surface.triangles().size(), 5u);
    EXPECT_EQ(surface.origin(4), 0);
    EXPECT_FALSE(surface.whole(4));
    EXPECT_DOUBLE_EQ(surface.displacement(4), 1.1e-3);
    EXPECT_DOUBLE_EQ(surface.largest_displacement(), 1.1e-3);
    EXPECT_TRUE(surface.touched(1));
    std::vector<std::int32_t> found;
    surface.for_each_near(surface.at(1), 0.1, [&](std::int32_t t) { found.push_back(t); });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, (std::vector<std::int32_t>{1, 2, 4}));
}

}  // namespace
}  // namespace mq::boolean
