// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/tensor_patch.h"

#include <gtest/gtest.h>

#include <random>

#include "elements/bezier/bernstein.h"
#include "elements/product/reference_nodes.h"

namespace mq::elements {
namespace {

/// A polynomial map of degree `order` along u and v each.
Vec3 mapped(int order, double u, double v) {
    const double x = std::pow(u - 0.3, order);
    const double y = std::pow(v + 0.2, order);
    return {u + 0.3 * x * y, v - 0.2 * x + 0.1 * y, 0.4 * x * y + u * v};
}

std::vector<Vec3> control_of(int order) {
    std::vector<Vec3> nodes;
    for (const GridPoint& at : gmsh_nodes(ElementKind::Quadrilateral, order)) {
        nodes.push_back(mapped(order, static_cast<double>(at[0]) / order, static_cast<double>(at[1]) / order));
    }
    return tensor_control(order, nodes);
}

TEST(TensorPatch, HalvesAreTheQuadrilateral) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int order = 1; order <= kMaxOrder; ++order) {
        const auto halves = halves_of_quadrilateral(order, control_of(order));
        const Lattice& lattice = Lattice::of(2, 2 * order);
        const std::array<std::array<int, 6>, 2> corners{{{0, 0, 1, 0, 1, 1}, {0, 0, 1, 1, 0, 1}}};
        for (int i = 0; i < 100; ++i) {
            Barycentric b{};
            b[1] = share(random);
            b[2] = share(random) * (1.0 - b[1]);
            b[0] = 1.0 - b[1] - b[2];
            for (std::size_t h = 0; h < 2; ++h) {
                const auto& c = corners[h];
                const Vec3 wanted =
                    mapped(order, b[0] * c[0] + b[1] * c[2] + b[2] * c[4], b[0] * c[1] + b[1] * c[3] + b[2] * c[5]);
                EXPECT_LT((value(lattice, halves[h], b) - wanted).norm(), 1e-12) << order;
                const std::vector<Vec3> raised = raised_to(2 * order + 2, lattice, halves[h]);
                EXPECT_LT((value(Lattice::of(2, 2 * order + 2), raised, b) - wanted).norm(), 1e-12) << order;
            }
        }
    }
}

TEST(TensorPatch, ControlPointsOfHalvesAreMeans) {
    for (int order = 1; order <= kMaxOrder; ++order) {
        const std::vector<Vec3> control = control_of(order);
        Box box;
        for (const Vec3& p : control) {
            box.add(p);
        }
        for (const std::vector<Vec3>& half : halves_of_quadrilateral(order, control)) {
            for (const Vec3& p : half) {
                EXPECT_TRUE(((p - box.low).array() > -1e-12).all() && ((box.high - p).array() > -1e-12).all());
            }
        }
    }
}

TEST(TensorPatch, TheNinthNodeFollowsFromEight) {
    std::vector<Vec3> nodes;
    for (const GridPoint& at : gmsh_nodes(ElementKind::Quadrilateral, 2)) {
        const double u = 0.5 * at[0];
        const double v = 0.5 * at[1];
        nodes.emplace_back(u + u * u * v, v - u * v * v, u * u);  // without a term u^2 v^2
    }
    const std::vector<Vec3> all = tensor_control(2, nodes);
    nodes.pop_back();
    const std::vector<Vec3> completed = tensor_control(2, nodes);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_LT((all[i] - completed[i]).norm(), 1e-14);
    }
}

}  // namespace
}  // namespace mq::elements
