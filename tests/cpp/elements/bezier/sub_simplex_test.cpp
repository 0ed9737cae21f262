// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/sub_simplex.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace mq::elements {
namespace {

double volume(const SimplexPart& part) {
    Eigen::Matrix4d corners;
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
            corners(i, k) = part[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
        }
    }
    return corners.determinant();
}

TEST(SubSimplex, HalvesShareTheMiddleAndHalveTheVolume) {
    const auto [first, second] = halve(kWholeSimplex, 1, 3);
    EXPECT_EQ(first[1], kWholeSimplex[1]) << "the first half keeps corner a";
    EXPECT_EQ(second[3], kWholeSimplex[3]);
    EXPECT_EQ(first[3], middle_of(kWholeSimplex[1], kWholeSimplex[3]));
    EXPECT_EQ(first[3], second[1]);
    EXPECT_NEAR(volume(first), 0.5, 1e-15);
    EXPECT_NEAR(volume(second), 0.5, 1e-15);
}

TEST(SubSimplex, TheLongestEdgeIsHalvedNextAndEqualOnesInOrder) {
    EXPECT_EQ(longest_edge(kWholeSimplex, 3), std::make_pair(0, 1)) << "all are equal";
    const SimplexPart half = halve(kWholeSimplex, 0, 1).first;
    const auto [a, b] = longest_edge(half, 3);
    EXPECT_TRUE(a != 0 || b != 1) << "edge (0, 1) was halved";
    EXPECT_EQ(longest_edge(half, 1), std::make_pair(0, 1)) << "an edge has no other one";
}

TEST(SubSimplex, RepeatedHalvingMakesPartsSmallInAllDirections) {
    SimplexPart part = kWholeSimplex;
    for (int i = 0; i < 12; ++i) {
        const auto [a, b] = longest_edge(part, 3);
        part = i % 2 == 0 ? halve(part, a, b).first : halve(part, a, b).second;
    }
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_LE(std::abs(part[a][k] - part[0][k]), 0.26);
        }
    }
    EXPECT_NEAR(volume(part), std::ldexp(1.0, -12), 1e-15);
}

}  // namespace
}  // namespace mq::elements
