// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/vertex_stars.h"

#include <gtest/gtest.h>

#include "mesh/random_triangles.h"

namespace mq::mesh {
namespace {

TEST(VertexStars, HaveAllCornersInOrder) {
    const std::vector<Triangle> triangles = random_triangles(3, 10, 50);
    const VertexStars stars(triangles, 10);
    std::size_t sum = 0;
    for (std::size_t v = 0; v < 10; ++v) {
        std::uint32_t previous = 0;
        for (const std::uint32_t corner : stars[v]) {
            EXPECT_EQ(triangles[corner / 3][corner % 3], static_cast<std::int32_t>(v));
            EXPECT_TRUE(corner > previous || corner == *stars[v].first);
            previous = corner;
        }
        sum += stars[v].size();
    }
    EXPECT_EQ(sum, 150u);
}

}  // namespace
}  // namespace mq::mesh
