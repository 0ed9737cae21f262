// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/validity.h"

#include <gtest/gtest.h>

#include "curve/elements.h"
#include "elements/bezier/jacobian_of_nodes.h"

namespace mq::elements {

using curve::identity;
using curve::nodes_of;

namespace {

/// The unit tetrahedron pressed against x = c: J = (x - c)^2 + h.
JacobianForm parabola(double c, double h) {
    const Lattice& lattice = Lattice::of(3, 3);
    return form_of(lattice, nodes_of(lattice, [&](const Vec3& x) {
                       return Vec3((std::pow(x.x() - c, 3) + std::pow(c, 3)) / 3.0 + h * x.x(), x.y(), x.z());
                   }));
}

TEST(Validity, FindsAHiddenMinimum) {
    for (const double c : {0.21, 0.4, 0.5, 0.77}) {
        const Validity above = check_positive(parabola(c, 1e-4));
        EXPECT_TRUE(above.valid);
        EXPECT_GT(above.minimum.low, 0.0);
        const Validity below = check_positive(parabola(c, -1e-4));
        EXPECT_FALSE(below.valid);
        EXPECT_TRUE(below.proven);
        EXPECT_LE(below.minimum.high, 0.0);
        EXPECT_NEAR(below.minimum.at[1], c, 0.02);
        const Minimum minimum = bound_minimum(parabola(c, 0.01), 1e-3);
        EXPECT_LE(minimum.low, 0.01 + 1e-15);
        EXPECT_GE(minimum.high, 0.01 - 1e-15);
        EXPECT_LE(minimum.high - minimum.low, 1e-3);
    }
}

TEST(Validity, ZeroIsInvalid) {
    const Validity touching = check_positive(parabola(0.37, 0.0));
    EXPECT_FALSE(touching.valid);
    const Validity at_corner = check_positive(parabola(0.0, 0.0));
    EXPECT_FALSE(at_corner.valid);
}

TEST(Validity, AgreesWithDenseSampling) {
    std::mt19937 random(6);
    int valid = 0;
    int invalid = 0;
    for (int i = 0; i < 300; ++i) {
        const int order = 2 + i % 3;
        const Lattice& lattice = Lattice::of(3, order);
        const std::vector<Vec3> control =
            nodes_to_bezier(lattice, curve::perturbed(nodes_of(lattice, identity), 0.35 / order, random));
        const Validity verdict = check_positive(jacobian_of(lattice, control));
        double least = 1e300;
        const Lattice& samples = Lattice::of(3, 10);
        for (int k = 0; k < samples.size(); ++k) {
            least = std::min(least, jacobian_at(lattice, control, samples.node(k)));
        }
        if (verdict.valid) {
            EXPECT_GT(least, 0.0);
            EXPECT_LE(verdict.minimum.low, least);
            ++valid;
        } else {
            EXPECT_TRUE(verdict.proven);
            EXPECT_LE(jacobian_at(lattice, control, verdict.minimum.at), 1e-12);
            ++invalid;
        }
    }
    EXPECT_GT(valid, 30);
    EXPECT_GT(invalid, 30);
}

/// Unit equilateral triangle, one edge bulged inwards by alpha: valid up to sqrt(3)/4 (equation (4) of section 5.5).
bool bulged_triangle_valid(double alpha) {
    const Lattice& lattice = Lattice::of(2, 2);
    const auto map = [&](const Vec3& x) {
        const Vec3 straight(x.x() + 0.5 * x.y(), 0.5 * std::sqrt(3.0) * x.y(), 0.0);
        return Vec3(straight + Vec3(0.0, alpha * 4.0 * x.x() * (1.0 - x.x() - x.y()), 0.0));
    };
    const std::vector<Vec3> nodes = nodes_of(lattice, map);
    const std::vector<Vec3> normals(nodes.size(), Vec3(0.0, 0.0, 1.0));
    return check_positive(normal_component(lattice, nodes_to_bezier(lattice, nodes), normals)).valid;
}

TEST(Validity, TheAllowableDeviationOfThePaper) {
    EXPECT_TRUE(bulged_triangle_valid(0.999 * std::sqrt(3.0) / 4.0));
    EXPECT_FALSE(bulged_triangle_valid(1.001 * std::sqrt(3.0) / 4.0));
}

TEST(Validity, NotANumberIsInvalid) {
    const Lattice& lattice = Lattice::of(3, 2);
    std::vector<Vec3> nodes = nodes_of(lattice, identity);
    nodes[1].x() = std::nan("");
    EXPECT_FALSE(check_positive(form_of(lattice, nodes)).valid);
}

}  // namespace
}  // namespace mq::elements
