// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/jacobian.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <random>

#include "curve/elements.h"
#include "elements/bezier/jacobian_of_nodes.h"
#include "elements/bezier/validity.h"

namespace mq::elements {

using curve::identity;
using curve::nodes_of;

namespace {

TEST(Jacobian, OfAnAffineMapIsItsDeterminant) {
    Eigen::Matrix3d matrix;
    matrix << 2.0, 0.3, 0.1, -0.4, 1.5, 0.2, 0.7, 0.1, 3.0;
    for (int order = 1; order <= 4; ++order) {
        const Lattice& lattice = Lattice::of(3, order);
        const JacobianForm form = form_of(lattice, nodes_of(lattice, [&](const Vec3& x) { return Vec3(matrix * x); }));
        for (const double c : form.coefficients) {
            EXPECT_NEAR(c, matrix.determinant(), 1e-12);
        }
        const Quality quality = quality_of(form, matrix.determinant());
        EXPECT_NEAR(quality.distortion, 1.0, kQualityAccuracy);
        EXPECT_NEAR(quality.scaled_jacobian, 1.0, kQualityAccuracy);
    }
}

TEST(Jacobian, ByNodesStaysPositiveHoweverTheNodesAreRounded) {
    constexpr double kUnits = 4.0;
    constexpr double kFar = 1000.0;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-kUnits, kUnits);
    for (int order = 2; order <= 4; ++order) {
        const Lattice& lattice = Lattice::of(3, order);
        const auto flat = [&](double height) {
            return nodes_of(lattice, [&](const Vec3& x) { return Vec3(kFar + x.x(), kFar + x.y(), height * x.z()); });
        };
        // The Jacobian is the height; the bound hardly depends on it.
        const double bound = jacobian_by_nodes(lattice, nodes_to_bezier(lattice, flat(0.0))).rounding;
        EXPECT_GT(bound, jacobian_of(lattice, nodes_to_bezier(lattice, flat(0.0))).rounding);
        const std::vector<Vec3> nodes = flat(1.01 * bound);
        for (int i = 0; i < 200; ++i) {
            std::vector<Vec3> rounded = nodes;
            for (Vec3& node : rounded) {
                node += kFar * std::numeric_limits<double>::epsilon() * Vec3(unit(random), unit(random), unit(random));
            }
            for (const double c : jacobian_of(lattice, nodes_to_bezier(lattice, rounded)).coefficients) {
                EXPECT_GT(c, 0.0) << order;
            }
        }
    }
}

TEST(Jacobian, PolynomialIsTheDeterminantEverywhere) {
    std::mt19937 random(5);
    for (int order = 2; order <= 4; ++order) {
        const Lattice& lattice = Lattice::of(3, order);
        const std::vector<Vec3> control =
            nodes_to_bezier(lattice, curve::perturbed(nodes_of(lattice, identity), 0.2 / order, random));
        const JacobianForm form = jacobian_of(lattice, control);
        for (int i = 0; i < 50; ++i) {
            const Barycentric at = curve::random_point(3, random);
            EXPECT_NEAR(value(form.lattice->factor(0), form.coefficients, at), jacobian_at(lattice, control, at),
                        1e-12);
        }
    }
}

}  // namespace
}  // namespace mq::elements
