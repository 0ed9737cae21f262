// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/product_lattice.h"

#include <gtest/gtest.h>

#include <random>

#include "curve/elements.h"
#include "elements/product/polynomial_map.h"

namespace mq::elements {
namespace {

TEST(ProductLattice, HalvesAreTheSamePolynomial) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const ProductLattice prism({{2, 4}, {1, 5}});
    std::vector<double> c(static_cast<std::size_t>(prism.size()));
    for (double& x : c) {
        x = uniform(random);
    }
    for (const auto& [f, a, b] : {std::array<int, 3>{0, 0, 2}, {0, 2, 1}, {1, 0, 1}}) {
        const auto [first, second] = prism.halve(c, f, a, b);
        for (int i = 0; i < 20; ++i) {
            ProductPoint inside{curve::random_point(2, random), curve::random_point(1, random), Barycentric{}};
            // A point of the first half keeps corner a: half of the weight of b goes there.
            ProductPoint whole = inside;
            auto& moved = whole[static_cast<std::size_t>(f)];
            const auto ka = static_cast<std::size_t>(a);
            const auto kb = static_cast<std::size_t>(b);
            moved[ka] += 0.5 * moved[kb];
            moved[kb] *= 0.5;
            EXPECT_NEAR(value_at(prism, first, inside), value_at(prism, c, whole), 1e-14);
            whole = inside;
            auto& other = whole[static_cast<std::size_t>(f)];
            other[kb] += 0.5 * other[ka];
            other[ka] *= 0.5;
            EXPECT_NEAR(value_at(prism, second, inside), value_at(prism, c, whole), 1e-14);
        }
    }
}

TEST(ProductLattice, IndicesAndCorners) {
    const ProductLattice cube({{1, 2}, {1, 3}, {1, 1}});
    EXPECT_EQ(cube.size(), 24);
    for (int i = 0; i < cube.size(); ++i) {
        EXPECT_EQ(cube.index(cube.indices(i)), i);
    }
    EXPECT_EQ(cube.corners(), (std::vector<int>{0, 1, 6, 7, 16, 17, 22, 23}));
    EXPECT_EQ(cube.multinomial(cube.index({1, 2, 0})), 6.0);
    EXPECT_EQ(cube.highest_degree(), 3);
}

}  // namespace
}  // namespace mq::elements
