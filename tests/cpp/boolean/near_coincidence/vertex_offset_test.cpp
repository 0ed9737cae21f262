// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/vertex_offset.h"

#include <gtest/gtest.h>

#include "boolean/soups.h"

namespace mq::boolean {
namespace {

TEST(VertexOffset, MovesEverySideOfABoxOutwardsByOne) {
    const Soup soup = soups::soup_of({solids::box(Vec3(-1, -1, -1), Vec3(1, 1, 1))});
    const VertexOffsets offsets(soup);
    for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
        // The corner of the box whose sides all moved outwards by 1.
        EXPECT_LT((offsets.at(v) - soup.vertices[v]).norm(), 1e-9) << offsets.at(v).transpose();
        EXPECT_EQ(offsets.operand(v), 0);
    }
}

TEST(VertexOffset, IsRadialOnASphere) {
    const Soup soup =
        soups::soup_of({solids::box(Vec3(5, 5, 5), Vec3(6, 6, 6)), solids::sphere(Vec3(0, 0, 0), 2.0, 12)});
    const VertexOffsets offsets(soup);
    for (std::size_t v = 8; v < soup.vertices.size(); ++v) {
        EXPECT_EQ(offsets.operand(v), 1);
        EXPECT_GT(offsets.at(v).normalized().dot(soup.vertices[v].normalized()), 0.99);
        EXPECT_NEAR(offsets.at(v).norm(), 1.0, 0.05);
    }
}

}  // namespace
}  // namespace mq::boolean
