// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/check_elements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "base/error.h"
#include "base/parallel.h"
#include "curve/elements.h"
#include "elements/product/polynomial_map.h"

namespace mq::elements {
namespace {

std::vector<std::int32_t> counted(std::size_t n) {
    std::vector<std::int32_t> all(n);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// One element whose nodes are these.
ElementVerdict verdict_of(ElementKind kind, int order, const std::vector<Vec3>& nodes) {
    const ElementVerdicts all =
        check_elements(kind, order, nodes, counted(nodes.size()), static_cast<int>(nodes.size()));
    EXPECT_EQ(all.verdict.size(), 1U);
    ElementVerdict one;
    one.low = all.low[0];
    one.high = all.high[0];
    one.verdict = static_cast<Verdict>(all.verdict[0]);
    return one;
}

void expect_distortion(const ElementVerdict& found, double distortion) {
    EXPECT_LE(found.low, distortion + 1e-12);
    EXPECT_GE(found.high, distortion - 1e-12);
    EXPECT_LE(found.high - found.low, 0.03);
}

std::vector<Vec3> moved(std::vector<Vec3> nodes, const std::function<Vec3(const Vec3&)>& map) {
    for (Vec3& x : nodes) {
        x = map(x);
    }
    return nodes;
}

TEST(CheckElements, StraightElementsHaveNoDistortion) {
    for (const ElementKind kind : kAllKinds) {
        for (int order = 1; order <= 5; ++order) {
            const std::vector<Vec3> nodes = moved(reference_nodes(kind, order), [](const Vec3& x) {
                return Vec3(2.0 * x.x() + x.y() + 5.0, 3.0 * x.y() - x.z(), 0.5 * x.z() + 0.1 * x.x());
            });
            const ElementVerdict found = verdict_of(kind, order, nodes);
            EXPECT_EQ(found.verdict, Verdict::Valid) << name_of(kind) << " " << order;
            EXPECT_GT(found.low, 1.0 - 1e-7);
            EXPECT_LE(found.high, 1.0);
        }
    }
}

TEST(CheckElements, MirroredSolidsAreInverted) {
    for (const ElementKind kind : kAllKinds) {
        for (int order = 1; order <= 3; ++order) {
            const std::vector<Vec3> nodes =
                moved(reference_nodes(kind, order), [](const Vec3& x) { return Vec3(-x.x(), x.y(), x.z()); });
            const ElementVerdict found = verdict_of(kind, order, nodes);
            const bool solid = dimension_of(kind) == 3;
            EXPECT_EQ(found.verdict, solid ? Verdict::Inverted : Verdict::Valid) << name_of(kind) << " " << order;
            if (solid) {
                EXPECT_EQ(found.low, -1.0);
                EXPECT_LT(found.high, -1.0 + 1e-7);
            }
        }
    }
}

/// The unit cube with the corner opposite to the origin at (c, c, c): J is 3 c - 2 there, and 1 at the origin.
ElementVerdict pushed_cube(double c) {
    return verdict_of(ElementKind::Hexahedron, 1,
                      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {c, c, c}, {0, 1, 1}});
}

TEST(CheckElements, CubeWithACornerPushedIn) {
    expect_distortion(pushed_cube(0.7), 0.1);
    EXPECT_EQ(pushed_cube(0.7).verdict, Verdict::Valid);
    EXPECT_EQ(pushed_cube(2.0 / 3.0 + 1e-12).verdict, Verdict::Valid);
    EXPECT_EQ(pushed_cube(2.0 / 3.0).verdict, Verdict::Folded);
    EXPECT_EQ(pushed_cube(2.0 / 3.0 - 1e-12).verdict, Verdict::Folded);
    expect_distortion(pushed_cube(0.6), -0.2);
    EXPECT_EQ(pushed_cube(0.6).verdict, Verdict::Folded);
}

TEST(CheckElements, HexahedronThatFoldsBetweenItsCorners) {
    // Slices across x are parallelograms with J = (1 - x)^2 - 3 x (1 - x) + x^2: 1 at all corners, -1/4 in the middle.
    const ElementVerdict found = verdict_of(
        ElementKind::Hexahedron, 1,
        {{0, 0, 0}, {1, 0, 0}, {1, -1.5, 1}, {0, 1, 0}, {0, 0, 1}, {1, 1.25, -1.5}, {1, -0.25, -0.5}, {0, 1, 1}});
    EXPECT_EQ(found.verdict, Verdict::Folded);
    expect_distortion(found, -0.25);
}

/// The unit tetrahedron with the middle of its first edge at (m, 0, 0): J goes from 4 m - 1 to 3 - 4 m.
ElementVerdict tetrahedron_with_middle(double m) {
    std::vector<Vec3> nodes = reference_nodes(ElementKind::Tetrahedron, 2);
    nodes[4].x() = m;
    return verdict_of(ElementKind::Tetrahedron, 2, nodes);
}

TEST(CheckElements, QuadraticTetrahedronWithAFoldedEdge) {
    EXPECT_EQ(tetrahedron_with_middle(0.3).verdict, Verdict::Valid);
    expect_distortion(tetrahedron_with_middle(0.3), 0.2 / 1.8);
    EXPECT_EQ(tetrahedron_with_middle(0.25).verdict, Verdict::Folded);
    EXPECT_EQ(tetrahedron_with_middle(0.2).verdict, Verdict::Folded);
    expect_distortion(tetrahedron_with_middle(0.2), -0.2 / 2.2);
}

ElementVerdict pushed_square(double c) {
    return verdict_of(ElementKind::Quadrilateral, 1, {{0, 0, 0}, {1, 0, 0}, {c, c, 0}, {0, 1, 0}});
}

TEST(CheckElements, Quadrilaterals) {
    EXPECT_EQ(pushed_square(0.6).verdict, Verdict::Valid);
    expect_distortion(pushed_square(0.6), 0.2);
    EXPECT_EQ(pushed_square(0.5).verdict, Verdict::Folded);
    expect_distortion(pushed_square(0.4), -0.2);
    // Crossed: half of it is seen from either side.
    EXPECT_EQ(verdict_of(ElementKind::Quadrilateral, 1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).verdict,
              Verdict::Folded);
    // A saddle: its normal has the same component along the mean everywhere, however high it is.
    const ElementVerdict saddle =
        verdict_of(ElementKind::Quadrilateral, 1, {{0, 0, 0}, {1, 0, 9}, {1, 1, 0}, {0, 1, 9}});
    EXPECT_EQ(saddle.verdict, Verdict::Valid);
    EXPECT_GT(saddle.low, 1.0 - 1e-7);
}

TEST(CheckElements, TriangleWithABulgedEdge) {
    // Equation (4) of Dey, O'Bara, Shephard 1999: an edge of the regular triangle may bulge inwards by sqrt(3) / 4.
    const auto bulged = [](double alpha) {
        const double h = 0.5 * std::sqrt(3.0);
        return verdict_of(ElementKind::Triangle, 2,
                          {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, alpha, 0}, {0.75, 0.5 * h, 0}, {0.25, 0.5 * h, 0}})
            .verdict;
    };
    EXPECT_EQ(bulged(0.999 * std::sqrt(3.0) / 4.0), Verdict::Valid);
    EXPECT_EQ(bulged(1.001 * std::sqrt(3.0) / 4.0), Verdict::Folded);
}

TEST(CheckElements, TwistedPrism) {
    // J is the square of |(1 - t) + t e^(i angle)|.
    const auto twisted = [](double c, double s) {
        return verdict_of(ElementKind::Prism, 1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {c, s, 1}, {-s, c, 1}});
    };
    const ElementVerdict third = twisted(-0.5, std::sqrt(0.75));
    EXPECT_EQ(third.verdict, Verdict::Valid);
    expect_distortion(third, 0.25);
    EXPECT_EQ(twisted(-1.0, 0.0).verdict, Verdict::Folded);
}

TEST(CheckElements, Pyramids) {
    // J is that of the base times the height.
    const auto pyramid = [](double c, double height) {
        return verdict_of(ElementKind::Pyramid, 1, {{-1, -1, 0}, {1, -1, 0}, {c, c, 0}, {-1, 1, 0}, {0.3, 0, height}});
    };
    EXPECT_EQ(pyramid(0.2, 2.0).verdict, Verdict::Valid);
    expect_distortion(pyramid(0.2, 2.0), 0.2);
    EXPECT_EQ(pyramid(0.0, 2.0).verdict, Verdict::Folded);
    expect_distortion(pyramid(-0.2, 2.0), -0.2);
    EXPECT_EQ(pyramid(0.2, -2.0).verdict, Verdict::Inverted);
    EXPECT_EQ(pyramid(1.0, 0.0).verdict, Verdict::Folded);
}

/// A point of a simplex, often on its boundary, with a chance of one in three for each side.
Barycentric often_on_boundary(int dimension, std::mt19937& random) {
    Barycentric b = curve::random_point(dimension, random);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(dimension); ++k) {
        if (random() % 3 == 0 && b[k] < 0.9) {
            const double rest = 1.0 - b[k];
            b[k] = 0.0;
            for (double& part : b) {
                part /= rest;
            }
        }
    }
    return b;
}

ProductPoint sample(ElementKind kind, std::mt19937& random) {
    ProductPoint place{};
    if (kind == ElementKind::Triangle || kind == ElementKind::Tetrahedron) {
        place[0] = often_on_boundary(dimension_of(kind), random);
        return place;
    }
    place[0] = often_on_boundary(kind == ElementKind::Prism ? 2 : 1, random);
    place[1] = often_on_boundary(1, random);
    // The formula of pyramids has no value at the apex.
    place[2] = kind == ElementKind::Pyramid ? curve::random_point(1, random) : often_on_boundary(1, random);
    return place;
}

TEST(CheckElements, AgreesWithDenseSampling) {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::array<int, 4> count{};
    for (int i = 0; i < 240; ++i) {
        const ElementKind kind = kAllKinds[static_cast<std::size_t>(i) % 6];
        const int order = 1 + i / 6 % 4;
        const PolynomialMap map(kind, order, false, 3.0 + 4.0 * uniform(random), random);
        const int nodes = full_node_count(kind, order);
        const ElementVerdict found = judge(ElementJacobian(kind, order, nodes).of(map.nodes(kind, order, nodes)));
        double least = 1e300;
        double most = 0.0;
        for (int k = 0; k < 1000; ++k) {
            const double j = map.jacobian(on_reference(kind, sample(kind, random)));
            least = std::min(least, j);
            most = std::max(most, std::abs(j));
        }
        ++count[static_cast<std::size_t>(found.verdict)];
        // A surface element has the sign of its mean.
        const bool turned = dimension_of(kind) == 2 && least < -0.5 * most;
        if (turned) {
            continue;
        }
        EXPECT_NE(found.verdict, Verdict::NotProven);
        EXPECT_EQ(found.verdict == Verdict::Valid, found.low > 0.0);
        if (found.verdict == Verdict::Valid) {
            EXPECT_GT(least, 0.0);
            EXPECT_LE(found.low, least / most);
        } else {
            EXPECT_LE(found.high, 1e-12);
        }
        EXPECT_LE(found.low, found.high);
        EXPECT_LE(found.high - found.low, 0.05);
        // `high` is attained. Near the apex of a pyramid the formula has no value.
        const Vec3 at = on_reference(kind, found.at);
        if (kind != ElementKind::Pyramid || at.z() < 1.0) {
            const double largest = std::max(most, std::abs(map.jacobian(at)));
            EXPECT_NEAR(map.jacobian(at) / largest, found.high, 0.1) << name_of(kind) << " " << order;
        }
    }
    EXPECT_GT(count[0], 40);
    EXPECT_GT(count[1], 40);
}

TEST(CheckElements, SizeAndPlaceDoNotMatter) {
    const std::vector<Vec3> nodes = reference_nodes(ElementKind::Hexahedron, 3);
    for (const double size : {1e-200, 1e-20, 1e20, 1e200}) {
        const ElementVerdict found =
            verdict_of(ElementKind::Hexahedron, 3, moved(nodes, [&](const Vec3& x) { return Vec3(size * x); }));
        EXPECT_EQ(found.verdict, Verdict::Valid);
        EXPECT_GT(found.low, 0.999);
    }
    EXPECT_EQ(verdict_of(ElementKind::Hexahedron, 3,
                         moved(nodes, [](const Vec3& x) { return Vec3(x + Vec3::Constant(1e6)); }))
                  .verdict,
              Verdict::Valid);
    // A layer ten thousand times as wide as it is high.
    EXPECT_EQ(verdict_of(ElementKind::Hexahedron, 3,
                         moved(nodes, [](const Vec3& x) { return Vec3(x.x(), x.y(), 1e-4 * x.z()); }))
                  .verdict,
              Verdict::Valid);
}

TEST(CheckElements, WithoutExtentOrBeyondNumbers) {
    EXPECT_EQ(verdict_of(ElementKind::Tetrahedron, 1, std::vector<Vec3>(4, Vec3(1, 2, 3))).verdict, Verdict::Folded);
    const double huge = std::numeric_limits<double>::max();
    const ElementVerdict found =
        verdict_of(ElementKind::Tetrahedron, 1, {{-huge, 0, 0}, {huge, 0, 0}, {huge, huge, 0}, {huge, 0, huge}});
    EXPECT_EQ(found.verdict, Verdict::NotProven);
    EXPECT_EQ(found.low, -1.0);
    EXPECT_EQ(found.high, 1.0);
}

TEST(CheckElements, SameBytesWhateverTheNumberOfThreads) {
    std::mt19937 random(22);
    std::vector<Vec3> nodes;
    for (int e = 0; e < 300; ++e) {
        const PolynomialMap map(ElementKind::Prism, 2, false, 4.0, random);
        const std::vector<Vec3> of_element = map.nodes(ElementKind::Prism, 2, 18);
        nodes.insert(nodes.end(), of_element.begin(), of_element.end());
    }
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return check_elements(ElementKind::Prism, 2, nodes, counted(nodes.size()), 18);
    };
    const ElementVerdicts one = with(1);
    const ElementVerdicts four = with(4);
    EXPECT_EQ(one.low, four.low);
    EXPECT_EQ(one.high, four.high);
    EXPECT_EQ(one.verdict, four.verdict);
}

std::string fault_of(const std::vector<Vec3>& nodes, const std::vector<std::int32_t>& connectivity, int width) {
    try {
        check_elements(ElementKind::Quadrilateral, 2, nodes, connectivity, width);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(CheckElements, FaultsOfTheInputAreNamed) {
    std::vector<Vec3> nodes = reference_nodes(ElementKind::Quadrilateral, 2);
    std::vector<std::int32_t> connectivity = counted(9);
    EXPECT_EQ(fault_of(nodes, connectivity, 9), "");
    EXPECT_EQ(fault_of(nodes, connectivity, 7),
              "a quadrilateral of order 2 has 9 nodes, or 8 at its corners and edges only, not 7");
    EXPECT_EQ(fault_of(nodes, connectivity, 8), "9 node numbers do not make whole elements of 8 nodes");
    connectivity[3] = 9;
    EXPECT_EQ(fault_of(nodes, connectivity, 9), "element 0 names node 9, but there are 9 nodes, counted from 0");
    connectivity[3] = -1;
    EXPECT_EQ(fault_of(nodes, connectivity, 9), "element 0 names node -1, but there are 9 nodes, counted from 0");
    nodes[2].y() = std::nan("");
    EXPECT_EQ(fault_of(nodes, counted(9), 9), "node 2 has a coordinate that is not a finite number");
    EXPECT_TRUE(check_elements(ElementKind::Prism, 2, {}, {}, 15).low.empty());
}

TEST(CheckElements, CanBeCancelled) {
    Progress progress;
    progress.cancel();
    const std::vector<Vec3> nodes = reference_nodes(ElementKind::Hexahedron, 1);
    EXPECT_THROW(check_elements(ElementKind::Hexahedron, 1, nodes, counted(8), 8, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::elements
