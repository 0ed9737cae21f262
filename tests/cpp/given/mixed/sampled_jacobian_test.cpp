// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/sampled_jacobian.h"

#include <gtest/gtest.h>

#include <random>

#include "elements/product/element_jacobian.h"
#include "elements/product/reference_nodes.h"

namespace mq::given {

using elements::ElementKind;
using elements::name_of;

namespace {

constexpr std::array<ElementKind, 4> kSolids{ElementKind::Tetrahedron, ElementKind::Pyramid, ElementKind::Prism,
                                             ElementKind::Hexahedron};

TEST(SampledJacobian, DerivativesAreThoseOfDifferences) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-0.1, 0.1);
    for (const ElementKind kind : kSolids) {
        for (int order = 1; order <= 3; ++order) {
            std::vector<Vec3> nodes = elements::reference_nodes(kind, order);
            for (Vec3& p : nodes) {
                p += Vec3(any(random), any(random), any(random));
            }
            const SampledJacobian& sampled = SampledJacobian::of(kind, order);
            std::vector<double> weights;
            for (Eigen::Index q = 0; q < sampled.samples(); ++q) {
                weights.push_back(any(random));
            }
            std::vector<Vec3> by(nodes.size(), Vec3::Zero());
            sampled.differentiate(nodes, weights, by);
            const auto sum = [&](const std::vector<Vec3>& at) {
                std::vector<double> j;
                sampled.evaluate(at, j);
                double total = 0.0;
                for (std::size_t q = 0; q < j.size(); ++q) {
                    total += weights[q] * j[q];
                }
                return total;
            };
            constexpr double kStep = 1e-6;
            for (std::size_t i = 0; i < nodes.size(); i += 3) {
                std::vector<Vec3> more = nodes;
                std::vector<Vec3> less = nodes;
                more[i].y() += kStep;
                less[i].y() -= kStep;
                EXPECT_NEAR((sum(more) - sum(less)) / (2 * kStep), by[i].y(), 1e-6) << name_of(kind) << " " << order;
            }
        }
    }
}

TEST(ElementVolume, IsThatOfTheReferenceElementAndScales) {
    const std::array<double, 4> volumes{1.0 / 6.0, 4.0 / 3.0, 1.0, 8.0};
    for (std::size_t k = 0; k < kSolids.size(); ++k) {
        for (int order = 1; order <= 3; ++order) {
            std::vector<Vec3> nodes = elements::reference_nodes(kSolids[k], order);
            const elements::ElementJacobian jacobian(kSolids[k], order, static_cast<int>(nodes.size()));
            EXPECT_NEAR(jacobian.volume(nodes), volumes[k], 1e-12) << name_of(kSolids[k]) << " " << order;
            for (Vec3& p : nodes) {
                p = Vec3(7.0 * p.x(), 11.0 * p.y(), 13.0 * p.z() + 2.0 * p.x());
            }
            EXPECT_NEAR(jacobian.volume(nodes), 1001.0 * volumes[k], 1e-9) << name_of(kSolids[k]) << " " << order;
        }
    }
}

}  // namespace
}  // namespace mq::given
