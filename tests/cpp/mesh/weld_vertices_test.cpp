// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/weld_vertices.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace mq::mesh {
namespace {

TEST(Weld, FindsTheFirstOfEqualVertices) {
    std::mt19937_64 random(4);
    std::uniform_int_distribution<int> integer(-2, 2);
    std::vector<Vec3> vertices;
    for (int i = 0; i < 400; ++i) {
        vertices.emplace_back(0.1 * integer(random), 0.1 * integer(random), 0.1 * integer(random));
    }
    vertices.emplace_back(-0.0, 0.0, -0.0);
    vertices.emplace_back(std::numeric_limits<double>::denorm_min(), 0.0, 0.0);
    const std::vector<std::int32_t> found = equal_vertices(vertices);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        std::int32_t first = 0;
        while (vertices[first] != vertices[v]) {
            ++first;
        }
        EXPECT_EQ(found[v], first);
    }
}

}  // namespace
}  // namespace mq::mesh
