// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/sampled_jacobian.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "base/memory/never_destroyed.h"
#include "elements/bezier/bernstein.h"
#include "elements/product/element_derivatives.h"

namespace mq::given {

using elements::ElementKind;
using elements::ProductLattice;
using elements::ProductPoint;

namespace {

/// Steps between sample points along an edge of the domain, less the order.
constexpr int kMoreSteps = 2;

/// Sample points of a product of simplices.
std::vector<ProductPoint> points_of(const ProductLattice& lattice, int steps) {
    std::vector<ProductPoint> points(1);
    for (int f = 0; f < lattice.factors(); ++f) {
        const elements::Lattice& places = elements::Lattice::of(lattice.factor(f).dimension(), steps);
        std::vector<ProductPoint> longer;
        for (const ProductPoint& before : points) {
            for (int i = 0; i < places.size(); ++i) {
                longer.push_back(before);
                longer.back()[static_cast<std::size_t>(f)] = places.node(i);
            }
        }
        points = std::move(longer);
    }
    return points;
}

/// Values of the Bernstein polynomials at points: (points, coefficients).
Eigen::MatrixXd values_of(const ProductLattice& lattice, const std::vector<ProductPoint>& points) {
    Eigen::MatrixXd values(static_cast<Eigen::Index>(points.size()), lattice.size());
    for (std::size_t q = 0; q < points.size(); ++q) {
        std::vector<std::vector<double>> of_factor;
        for (int f = 0; f < lattice.factors(); ++f) {
            of_factor.push_back(elements::bernstein_values(lattice.factor(f), points[q][static_cast<std::size_t>(f)]));
        }
        for (int i = 0; i < lattice.size(); ++i) {
            const ProductLattice::Indices at = lattice.indices(i);
            double product = 1.0;
            for (std::size_t f = 0; f < of_factor.size(); ++f) {
                product *= of_factor[f][static_cast<std::size_t>(at[f])];
            }
            values(static_cast<Eigen::Index>(q), i) = product;
        }
    }
    return values;
}

}  // namespace

SampledJacobian::SampledJacobian(ElementKind kind, int order) {
    const std::vector<elements::NodalPolynomial> derivatives =
        elements::derivatives_of(kind, order, elements::full_node_count(kind, order));
    const std::vector<ProductPoint> points = points_of(derivatives[0].lattice, order + kMoreSteps);
    for (std::size_t k = 0; k < 3; ++k) {
        gradients_[k] = values_of(derivatives[k].lattice, points) * derivatives[k].from_nodes.cast<double>();
    }
}

const SampledJacobian& SampledJacobian::of(ElementKind kind, int order) {
    static std::mutex mutex;
    static auto& known = never_destroyed<std::map<std::pair<ElementKind, int>, std::unique_ptr<SampledJacobian>>>({});
    const std::lock_guard<std::mutex> lock(mutex);
    std::unique_ptr<SampledJacobian>& made = known[{kind, order}];
    if (!made) {
        made.reset(new SampledJacobian(kind, order));
    }
    return *made;
}

std::array<SampledJacobian::Coordinates, 3> SampledJacobian::derivatives(const std::vector<Vec3>& nodes) const {
    Coordinates x(static_cast<Eigen::Index>(nodes.size()), 3);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        x.row(static_cast<Eigen::Index>(i)) = (nodes[i] - nodes[0]).transpose();
    }
    return {gradients_[0] * x, gradients_[1] * x, gradients_[2] * x};
}

void SampledJacobian::evaluate(const std::vector<Vec3>& nodes, std::vector<double>& jacobians) const {
    const auto d = derivatives(nodes);
    jacobians.resize(static_cast<std::size_t>(samples()));
    for (Eigen::Index q = 0; q < samples(); ++q) {
        const Vec3 a = d[0].row(q);
        const Vec3 b = d[1].row(q);
        const Vec3 c = d[2].row(q);
        jacobians[static_cast<std::size_t>(q)] = a.dot(b.cross(c));
    }
}

void SampledJacobian::differentiate(const std::vector<Vec3>& nodes, const std::vector<double>& weights,
                                    std::vector<Vec3>& by_nodes) const {
    const auto d = derivatives(nodes);
    std::array<Coordinates, 3> by;
    for (Coordinates& of_derivative : by) {
        of_derivative.resize(samples(), 3);
    }
    for (Eigen::Index q = 0; q < samples(); ++q) {
        const Vec3 a = d[0].row(q);
        const Vec3 b = d[1].row(q);
        const Vec3 c = d[2].row(q);
        const double w = weights[static_cast<std::size_t>(q)];
        by[0].row(q) = w * b.cross(c).transpose();
        by[1].row(q) = w * c.cross(a).transpose();
        by[2].row(q) = w * a.cross(b).transpose();
    }
    Coordinates sum = gradients_[0].transpose() * by[0];
    sum += gradients_[1].transpose() * by[1];
    sum += gradients_[2].transpose() * by[2];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        by_nodes[i] += sum.row(static_cast<Eigen::Index>(i)).transpose();
    }
}

}  // namespace mq::given
