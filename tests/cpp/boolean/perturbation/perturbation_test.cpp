// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/perturbation/perturbation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "boolean/soups.h"

namespace mq::boolean {
namespace {

constexpr double kLength = 1e-3;  // mm

TEST(Perturbation, MovesTheVerticesOfTheOtherOperandsByNoMoreThanTheLength) {
    const Soup before = soups::soup_of(soups::overlapping_cubes());
    Soup soup = before;
    // Triangle 0 is the first operand's, 12 the second one's.
    const double largest = perturb(soup, {0, 12}, kLength, 1);
    EXPECT_GT(largest, 0.0);
    EXPECT_LE(largest, std::sqrt(3.0) * kLength * (1.0 + 1e-6));
    for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
        const Vec3 way = soup.vertices[v] - before.vertices[v];
        const Triangle& t = soup.triangles[12];
        const bool may_move = std::find(t.begin(), t.end(), static_cast<std::int32_t>(v)) != t.end();
        EXPECT_EQ(way != Vec3::Zero(), may_move) << v;
        EXPECT_EQ(soup.moved[v] != 0, may_move) << v;
        EXPECT_LE(way.cwiseAbs().maxCoeff(), kLength * (1.0 + 1e-3));
        EXPECT_TRUE(is_single(soup.vertices[v]));
    }
}

TEST(Perturbation, MovesTheFirstOperandWhereNoOtherIsNamed) {
    Soup soup = soups::soup_of(soups::overlapping_cubes());
    EXPECT_GT(perturb(soup, {0}, kLength, 1), 0.0);
    EXPECT_NE(soup.moved[static_cast<std::size_t>(soup.triangles[0][0])], 0);
}

TEST(Perturbation, DependsOnTheDrawAndOnNothingElse) {
    const auto moved = [](std::uint64_t draw) {
        Soup soup = soups::soup_of(soups::overlapping_cubes());
        perturb(soup, {12, 13, 14}, kLength, draw);
        return soup.vertices;
    };
    EXPECT_EQ(moved(1), moved(1));
    EXPECT_NE(moved(1), moved(2));
}

TEST(Perturbation, MovesThatLeaveATriangleWithoutAreaAreUndone) {
    const Soup before = soups::soup_of(soups::overlapping_cubes());
    Soup soup = before;
    soup.moved.assign(soup.vertices.size(), 0);
    const Triangle& t = soup.triangles[0];
    const auto corner = [&](std::size_t k) -> Vec3& { return soup.vertices[static_cast<std::size_t>(t[k])]; };
    corner(0) = 0.5 * (corner(1) + corner(2));
    soup.moved[static_cast<std::size_t>(t[0])] = 1;
    undo_degenerate_moves(soup, before.vertices);
    EXPECT_EQ(soup.vertices, before.vertices);
    EXPECT_EQ(soup.moved[static_cast<std::size_t>(t[0])], 0);
}

}  // namespace
}  // namespace mq::boolean
