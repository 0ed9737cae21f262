// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "elements/bezier/bernstein.h"

namespace mq::curve {

/// Elements whose Jacobians are evaluated at a time: each arithmetic operation is done for all of them, which compilers
/// turn into vector instructions.
constexpr int kLanes = 4;
using Lanes = Eigen::Array<double, kLanes, 1>;

/// A vector of each element of a batch.
struct LaneVector {
    Lanes x = Lanes::Zero();
    Lanes y = Lanes::Zero();
    Lanes z = Lanes::Zero();

    void add(const Lanes& weight, const LaneVector& v) {
        x += weight * v.x;
        y += weight * v.y;
        z += weight * v.z;
    }
    /// Adds `weight` times the cross product of two vectors.
    void add_cross(double weight, const LaneVector& a, const LaneVector& b) {
        x += weight * (a.y * b.z - a.z * b.y);
        y += weight * (a.z * b.x - a.x * b.z);
        z += weight * (a.x * b.y - a.y * b.x);
    }
    Lanes dot(const LaneVector& v) const { return x * v.x + y * v.y + z * v.z; }
};

/// The Bernstein coefficients of the Jacobians of a batch of tetrahedra, and their derivatives by the control points,
/// on buffers that are used again.
class JacobianBatch {
  public:
    explicit JacobianBatch(const elements::Lattice& lattice);

    /// The control points, to be set before `evaluate`.
    std::vector<LaneVector> control;
    std::vector<Lanes> coefficients;

    void evaluate();
    /// Differentiates the sum of the coefficients multiplied by `weights`; call after `evaluate`.
    void differentiate_sum(const std::vector<Lanes>& weights, std::vector<LaneVector>& by_control);

  private:
    /// Coefficient i of one factor times j of the other adds to coefficient `target` of the product.
    struct Term {
        int i;
        int j;
        int target;
        double weight;
    };
    static std::vector<Term> product(int m, int n);

    int degree_;
    std::vector<Term> first_;   // products of two derivatives
    std::vector<Term> second_;  // products of the third derivative with the cross product of the first two
    /// By direction and coefficient of a derivative: the control points whose difference it is.
    std::array<std::vector<std::pair<std::size_t, std::size_t>>, 3> ends_;
    std::array<std::vector<LaneVector>, 3> derivatives_;
    std::array<std::vector<LaneVector>, 3> by_derivatives_;
    std::vector<LaneVector> crosses_;
    std::vector<LaneVector> by_cross_;
};

}  // namespace mq::curve
