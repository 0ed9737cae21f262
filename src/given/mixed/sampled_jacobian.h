// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/vec.h"
#include "elements/product/element_kind.h"

namespace mq::given {

/// J of solid elements at points spread evenly over the element and its boundary, and its derivatives by the nodes.
/// Fast, but no proof.
class SampledJacobian {
  public:
    static const SampledJacobian& of(elements::ElementKind kind, int order);

    Eigen::Index samples() const { return gradients_[0].rows(); }
    void evaluate(const std::vector<Vec3>& nodes, std::vector<double>& jacobians) const;
    /// Adds the derivative by the nodes of the sum over all samples of J times `weights`.
    void differentiate(const std::vector<Vec3>& nodes, const std::vector<double>& weights,
                       std::vector<Vec3>& by_nodes) const;

  private:
    SampledJacobian(elements::ElementKind kind, int order);

    using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, 3>;
    std::array<Coordinates, 3> derivatives(const std::vector<Vec3>& nodes) const;

    std::array<Eigen::MatrixXd, 3> gradients_;  ///< (samples, nodes)
};

}  // namespace mq::given
