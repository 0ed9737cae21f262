// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/jacobian_batch.h"

#include <gtest/gtest.h>

#include <random>

#include "elements/bezier/jacobian.h"

namespace mq::curve {

using elements::Lattice;

namespace {

using Elements = std::array<std::vector<Vec3>, kLanes>;

Elements random_elements(const Lattice& lattice) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-0.1, 0.1);
    Elements elements;
    for (std::vector<Vec3>& control : elements) {
        for (int i = 0; i < lattice.size(); ++i) {
            const elements::Barycentric b = lattice.node(i);
            control.emplace_back(b[1] + uniform(random), b[2] + uniform(random), b[3] + uniform(random));
        }
    }
    return elements;
}

void put(const Elements& elements, JacobianBatch& batch) {
    for (std::size_t lane = 0; lane < elements.size(); ++lane) {
        const auto l = static_cast<Eigen::Index>(lane);
        for (std::size_t p = 0; p < batch.control.size(); ++p) {
            const Vec3& point = elements[lane][p];
            batch.control[p].x[l] = point.x();
            batch.control[p].y[l] = point.y();
            batch.control[p].z[l] = point.z();
        }
    }
    batch.evaluate();
}

TEST(JacobianBatch, IsTheJacobianOfEachElement) {
    for (int order = 2; order <= 4; ++order) {
        const Lattice& lattice = Lattice::of(3, order);
        const Elements elements = random_elements(lattice);
        JacobianBatch batch(lattice);
        put(elements, batch);
        for (std::size_t lane = 0; lane < elements.size(); ++lane) {
            const std::vector<double> expected = elements::jacobian_of(lattice, elements[lane]).coefficients;
            ASSERT_EQ(batch.coefficients.size(), expected.size());
            for (std::size_t k = 0; k < expected.size(); ++k) {
                EXPECT_NEAR(batch.coefficients[k][static_cast<Eigen::Index>(lane)], expected[k], 1e-12);
            }
        }
    }
}

TEST(JacobianBatch, DerivativesAreThoseOfDifferences) {
    constexpr double kStep = 1e-5;
    for (int order = 2; order <= 4; ++order) {
        const Lattice& lattice = Lattice::of(3, order);
        const Elements elements = random_elements(lattice);
        JacobianBatch batch(lattice);
        std::vector<Lanes> weights(batch.coefficients.size());
        for (std::size_t k = 0; k < weights.size(); ++k) {
            weights[k].setConstant(1.0 / (1.0 + static_cast<double>(k)));
        }
        const auto sum = [&](const Elements& at) {
            put(at, batch);
            Lanes total = Lanes::Zero();
            for (std::size_t k = 0; k < weights.size(); ++k) {
                total += weights[k] * batch.coefficients[k];
            }
            return total;
        };
        put(elements, batch);
        std::vector<LaneVector> by_control;
        batch.differentiate_sum(weights, by_control);
        for (const std::size_t p : {std::size_t{0}, std::size_t{1}, batch.control.size() - 1}) {
            Elements before = elements;
            Elements after = elements;
            for (std::size_t lane = 0; lane < elements.size(); ++lane) {
                before[lane][p].y() -= kStep;
                after[lane][p].y() += kStep;
            }
            const Lanes slope = (sum(after) - sum(before)) / (2.0 * kStep);
            EXPECT_LT((slope - by_control[p].y).abs().maxCoeff(), 1e-7) << order << " " << p;
        }
    }
}

}  // namespace
}  // namespace mq::curve
