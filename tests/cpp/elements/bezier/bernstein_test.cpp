// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/bernstein.h"

#include <gtest/gtest.h>

#include "curve/elements.h"

namespace mq::elements {

using curve::identity;
using curve::nodes_of;
using curve::perturbed;
using curve::random_point;

namespace {

TEST(Bernstein, NodesAndControlPointsAreTheSamePolynomial) {
    std::mt19937 random(1);
    for (int dimension = 1; dimension <= 3; ++dimension) {
        for (int order = 1; order <= kMaxOrder; ++order) {
            const Lattice& lattice = Lattice::of(dimension, order);
            const std::vector<Vec3> nodes = perturbed(nodes_of(lattice, identity), 0.3, random);
            const std::vector<Vec3> control = nodes_to_bezier(lattice, nodes);
            const std::vector<Vec3> back = bezier_to_nodes(lattice, control);
            for (int i = 0; i < lattice.size(); ++i) {
                const auto k = static_cast<std::size_t>(i);
                EXPECT_LT((back[k] - nodes[k]).norm(), 1e-13);
                EXPECT_LT((value(lattice, control, lattice.node(i)) - nodes[k]).norm(), 1e-13);
            }
        }
    }
}

TEST(Bernstein, DerivativeIsTheSlope) {
    std::mt19937 random(2);
    for (int order = 1; order <= 4; ++order) {
        const Lattice& lattice = Lattice::of(3, order);
        const std::vector<Vec3> control = perturbed(nodes_of(lattice, identity), 0.3, random);
        const Barycentric at = random_point(3, random);
        for (int k = 1; k <= 3; ++k) {
            // Step of the difference quotient, in barycentric coordinates.
            constexpr double kStep = 1e-6;
            Barycentric ahead = at;
            Barycentric behind = at;
            ahead[0] -= kStep;
            ahead[static_cast<std::size_t>(k)] += kStep;
            behind[0] += kStep;
            behind[static_cast<std::size_t>(k)] -= kStep;
            const Vec3 slope = (value(lattice, control, ahead) - value(lattice, control, behind)) / (2.0 * kStep);
            const Vec3 exact = value(Lattice::of(3, order - 1), derivative(lattice, control, k), at);
            EXPECT_LT((slope - exact).norm(), 1e-8);
        }
    }
}

TEST(Bernstein, ProductsAreProducts) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int dimension = 1; dimension <= 3; ++dimension) {
        const Lattice& a = Lattice::of(dimension, 2);
        const Lattice& b = Lattice::of(dimension, 3);
        const Lattice& c = Lattice::of(dimension, 5);
        std::vector<double> x(static_cast<std::size_t>(a.size()));
        std::vector<double> y(static_cast<std::size_t>(b.size()));
        std::vector<double> z(static_cast<std::size_t>(c.size()), 0.0);
        for (double& v : x) {
            v = uniform(random);
        }
        for (double& v : y) {
            v = uniform(random);
        }
        const ProductTable& table = ProductTable::of(dimension, 2, 3);
        for (int i = 0; i < a.size(); ++i) {
            for (int j = 0; j < b.size(); ++j) {
                z[static_cast<std::size_t>(table.at(i, j).target)] +=
                    table.at(i, j).weight * x[static_cast<std::size_t>(i)] * y[static_cast<std::size_t>(j)];
            }
        }
        const Barycentric at = random_point(dimension, random);
        EXPECT_NEAR(value(c, z, at), value(a, x, at) * value(b, y, at), 1e-13);
    }
}

TEST(Bernstein, HalvesAreTheSamePolynomial) {
    std::mt19937 random(4);
    for (int dimension = 1; dimension <= 3; ++dimension) {
        const Lattice& lattice = Lattice::of(dimension, 4);
        const std::vector<Vec3> control = perturbed(nodes_of(lattice, identity), 0.3, random);
        for (int a = 0; a <= dimension; ++a) {
            for (int b = 0; b <= dimension; ++b) {
                if (a == b) {
                    continue;
                }
                const auto [first, second] = halve(lattice, control, a, b);
                const Barycentric at = random_point(dimension, random);
                const auto ka = static_cast<std::size_t>(a);
                const auto kb = static_cast<std::size_t>(b);
                // Corner b of the first half is the middle of the edge; corner a of the second.
                Barycentric whole = at;
                whole[ka] += 0.5 * at[kb];
                whole[kb] = 0.5 * at[kb];
                EXPECT_LT((value(lattice, first, at) - value(lattice, control, whole)).norm(), 1e-14);
                whole = at;
                whole[kb] += 0.5 * at[ka];
                whole[ka] = 0.5 * at[ka];
                EXPECT_LT((value(lattice, second, at) - value(lattice, control, whole)).norm(), 1e-14);
            }
        }
    }
}

}  // namespace
}  // namespace mq::elements
