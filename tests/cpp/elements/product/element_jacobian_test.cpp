// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/element_jacobian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"
#include "curve/elements.h"
#include "elements/product/polynomial_map.h"

namespace mq::elements {
namespace {

ProductPoint random_place(const ProductLattice& lattice, std::mt19937& random) {
    ProductPoint p{};
    for (int f = 0; f < lattice.factors(); ++f) {
        p[static_cast<std::size_t>(f)] = curve::random_point(lattice.factor(f).dimension(), random);
    }
    return p;
}

double largest_of(const JacobianForm& form) {
    double most = 0.0;
    for (const double c : form.coefficients) {
        most = std::max(most, std::abs(c));
    }
    return most;
}

/// The form is the Jacobian by formula at random places, up to one factor.
void expect_jacobian(ElementKind kind, int order, bool serendipity, std::mt19937& random) {
    const int nodes = serendipity ? serendipity_node_count(kind, order) : full_node_count(kind, order);
    const ElementJacobian jacobian(kind, order, nodes);
    for (int repeat = 0; repeat < 3; ++repeat) {
        const PolynomialMap map(kind, order, serendipity, 2.0, random);
        const JacobianForm form = jacobian.of(map.nodes(kind, order, nodes));
        double factor = 0.0;
        for (int i = 0; i < 10; ++i) {
            const ProductPoint place = random_place(*form.lattice, random);
            const double expected = map.jacobian(on_reference(kind, place));
            const double found = value_at(*form.lattice, form.coefficients, place);
            factor = i == 0 ? found / expected : factor;
            EXPECT_NEAR(found, factor * expected, 1e-10 * std::abs(factor)) << name_of(kind) << " " << order;
        }
        EXPECT_LT(form.rounding, 1e-7 * std::abs(factor)) << name_of(kind) << " " << order;
    }
}

TEST(ElementJacobian, IsThatOfKnownMaps) {
    std::mt19937 random(11);
    for (const ElementKind kind : kAllKinds) {
        for (int order = 1; order <= 5; ++order) {
            expect_jacobian(kind, order, false, random);
        }
    }
}

TEST(ElementJacobian, SerendipityElementsAreCompletedExactly) {
    std::mt19937 random(12);
    for (const ElementKind kind :
         {ElementKind::Quadrilateral, ElementKind::Pyramid, ElementKind::Prism, ElementKind::Hexahedron}) {
        expect_jacobian(kind, 2, true, random);
    }
}

TEST(ElementJacobian, RoundingIsWithinItsBound) {
    // Nodes with few binary digits, and far from the origin: what is computed in other units differs by rounding only.
    std::mt19937 random(13);
    std::uniform_int_distribution<int> whole(-64, 64);
    for (const ElementKind kind : kAllKinds) {
        const ElementJacobian jacobian(kind, 3, full_node_count(kind, 3));
        std::vector<Vec3> nodes;
        for (const Vec3& x : reference_nodes(kind, 3)) {
            nodes.emplace_back(Vec3((192.0 * x).array().round()) + Vec3(whole(random), whole(random), whole(random)));
        }
        const JacobianForm form = jacobian.of(nodes);
        for (Vec3& x : nodes) {
            x = 3.0 * x + Vec3(3e5, -7e5, 1e6);
        }
        const JacobianForm other = jacobian.of(nodes);
        const double factor = largest_of(other) / largest_of(form);
        for (std::size_t i = 0; i < form.coefficients.size(); ++i) {
            EXPECT_LE(std::abs(other.coefficients[i] - factor * form.coefficients[i]),
                      2.0 * (other.rounding + factor * form.rounding));
        }
    }
}

TEST(ElementJacobian, RefusesOtherNumbersOfNodes) {
    EXPECT_THROW(ElementJacobian(ElementKind::Hexahedron, 2, 21), InvalidInput);
    EXPECT_THROW(ElementJacobian(ElementKind::Hexahedron, 3, 32), InvalidInput);
    EXPECT_THROW(ElementJacobian(ElementKind::Triangle, 2, 0), InvalidInput);
}

}  // namespace
}  // namespace mq::elements
