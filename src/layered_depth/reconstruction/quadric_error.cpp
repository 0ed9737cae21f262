// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/quadric_error.h"

#include <Eigen/Eigenvalues>

#include "layered_depth/reconstruction/tuning.h"

namespace mq::layered_depth {

void Quadric::add(const Vec3& point, const Vec3& normal) {
    normal_.noalias() += normal * normal.transpose();
    moment_ += normal * normal.dot(point);
    sum_ += point;
    ++count_;
}

Vec3 Quadric::minimiser(const Vec3& low, const Vec3& high) const {
    const Vec3 mean = sum_ / count_;
    // The matrix is symmetric and positive semidefinite: its eigenvalues are the squared singular values of the matrix
    // of the planes.
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> svd;
    svd.computeDirect(normal_);
    const Vec3 rest = moment_ - normal_ * mean;
    const double least = ReconstructionTuning::kSingular * ReconstructionTuning::kSingular * svd.eigenvalues()[2];
    for (int smallest = 0; smallest < 3; ++smallest) {
        Vec3 point = mean;
        for (int i = smallest; i < 3; ++i) {
            if (svd.eigenvalues()[i] > least) {
                point += svd.eigenvectors().col(i) * (svd.eigenvectors().col(i).dot(rest) / svd.eigenvalues()[i]);
            }
        }
        const Vec3 within = point.cwiseMax(low).cwiseMin(high);
        if ((point - within).cwiseAbs().maxCoeff() <= ReconstructionTuning::kOvershoot) {
            return within;
        }
    }
    return mean.cwiseMax(low).cwiseMin(high);
}

}  // namespace mq::layered_depth
