// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "base/vec.h"

namespace mq::contour {

/// A sum of squared distances from planes (Garland and Heckbert 1997), as a function of a point.
class Quadric {
  public:
    /// @param normal  of length 1
    /// @param weight  of the square
    void add_plane(const Vec3& point, const Vec3& normal, double weight) {
        const double offset = normal.dot(point);
        matrix_ += weight * normal * normal.transpose();
        vector_ += weight * offset * normal;
        constant_ += weight * offset * offset;
    }
    void add(const Quadric& other) {
        matrix_ += other.matrix_;
        vector_ += other.vector_;
        constant_ += other.constant_;
    }
    double at(const Vec3& p) const { return p.dot(matrix_ * p) - 2.0 * vector_.dot(p) + constant_; }
    /// The point with the least value that is nearest to `start`. Principal values below `flat_share` of the largest
    /// one count as 0, so that the point does not move along their directions.
    Vec3 least(const Vec3& start, double flat_share) const {
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
        solver.computeDirect(matrix_);
        const Vec3 right = vector_ - matrix_ * start;
        Vec3 result = start;
        for (int k = 0; k < 3; ++k) {
            const double value = solver.eigenvalues()[k];
            if (value > 0.0 && value > flat_share * solver.eigenvalues()[2]) {
                const Vec3 axis = solver.eigenvectors().col(k);
                result += axis * (axis.dot(right) / value);
            }
        }
        return result;
    }

  private:
    Eigen::Matrix<double, 3, 3, Eigen::DontAlign> matrix_ = Eigen::Matrix<double, 3, 3, Eigen::DontAlign>::Zero();
    Vec3 vector_ = Vec3::Zero();
    double constant_ = 0.0;
};

}  // namespace mq::contour
