// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/blending.h"

#include <gtest/gtest.h>

#include <random>

#include "curve/elements.h"

namespace mq::elements {

using curve::identity;

namespace {

/// A polynomial map of the degree with random coefficients that grow smaller with the degree.
std::function<Vec3(const Vec3&)> random_map(int degree, std::mt19937& random) {
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    std::vector<Vec3> coefficients(static_cast<std::size_t>(3 * degree + 1));
    for (Vec3& c : coefficients) {
        c = Vec3(real(random), real(random), real(random));
    }
    return [=](const Vec3& x) {
        Vec3 sum = coefficients[0];
        for (int d = 1; d <= degree; ++d) {
            const Vec3 powers(std::pow(x.x() + 0.3 * x.y(), d), std::pow(x.y() - x.z(), d), std::pow(x.z(), d));
            for (int k = 0; k < 3; ++k) {
                sum += powers[k] * coefficients[static_cast<std::size_t>(3 * d - 2 + k)];
            }
        }
        return sum;
    };
}

/// The control points of the map, with the inner ones blended from the others; and how far that moved them.
double moved_by_blending(int dimension, int order, const std::function<Vec3(const Vec3&)>& map) {
    const Lattice& lattice = Lattice::of(dimension, order);
    const std::vector<Vec3> exact = nodes_to_bezier(lattice, curve::nodes_of(lattice, map));
    std::vector<Vec3> control = exact;
    for (int i = 0; i < lattice.size(); ++i) {
        if (lattice.carriers(i) == dimension + 1) {
            control[static_cast<std::size_t>(i)] = Vec3(7.0, 7.0, 7.0);
        }
    }
    dimension == 2 ? blend_triangle(lattice, control) : blend_tetrahedron(lattice, control);
    double largest = 0.0;
    for (std::size_t i = 0; i < control.size(); ++i) {
        largest = std::max(largest, (control[i] - exact[i]).norm());
    }
    return largest;
}

TEST(Blending, TrianglesReproduceQuadratics) {
    std::mt19937 random(1);
    for (int order = 3; order <= kMaxOrder; ++order) {
        EXPECT_LT(moved_by_blending(2, order, identity), 1e-12);
        EXPECT_LT(moved_by_blending(2, order, random_map(2, random)), 1e-12) << order;
        EXPECT_GT(moved_by_blending(2, order, random_map(3, random)), 1e-6) << "of higher degrees they are no copies";
    }
}

TEST(Blending, TetrahedraReproduceOneDegreeLess) {
    std::mt19937 random(2);
    for (int i = 0; i < 10; ++i) {
        EXPECT_LT(moved_by_blending(3, 4, random_map(3, random)), 1e-11);
        EXPECT_GT(moved_by_blending(3, 4, random_map(4, random)), 1e-6);
    }
}

TEST(Blending, TheGradientFollowsTheInnerControlPoints) {
    std::mt19937 random(3);
    const Lattice& lattice = Lattice::of(3, 4);
    const auto blended = [&](std::vector<Vec3> control) {
        blend_tetrahedron(lattice, control);
        return control;
    };
    const std::vector<Vec3> control = curve::perturbed(curve::nodes_of(lattice, identity), 0.3, random);
    // The function is the sum of all products of the control points with fixed weights.
    const std::vector<Vec3> weights = curve::perturbed(std::vector<Vec3>(control.size(), Vec3::Zero()), 1.0, random);
    const auto value_of = [&](const std::vector<Vec3>& c) {
        double sum = 0.0;
        for (std::size_t i = 0; i < c.size(); ++i) {
            sum += c[i].dot(weights[i]);
        }
        return sum;
    };
    std::vector<Vec3> gradient = weights;
    spread_inner_gradient(lattice, gradient);
    for (int i = 0; i < lattice.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (lattice.carriers(i) == 4) {
            EXPECT_EQ(gradient[k], Vec3::Zero());
            continue;
        }
        std::vector<Vec3> further = control;
        further[k] += Vec3::UnitX();
        EXPECT_NEAR(value_of(blended(further)) - value_of(blended(control)), gradient[k].x(), 1e-11);
    }
}

}  // namespace
}  // namespace mq::elements
