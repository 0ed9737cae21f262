// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/quadric.h"

#include <Eigen/Eigenvalues>

namespace mq::boolean {

namespace {

/// Singular values below this fraction of the largest count as zero: planes that differ by less than about 6 degrees
/// do not define an edge.
constexpr double kSingular = 0.1;

}  // namespace

void Quadric::add(const Vec3& point, const Vec3& normal) {
    normal_.noalias() += normal * normal.transpose();
    moment_ += normal * normal.dot(point);
    sum_ += point;
    ++count_;
}

Vec3 Quadric::minimiser() const {
    const Vec3 mean = sum_ / count_;
    // The matrix is symmetric and not negative: its eigenvalues are the squared singular values of the planes' matrix.
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> svd;
    svd.computeDirect(normal_);
    const Vec3 rest = moment_ - normal_ * mean;
    Vec3 shift = Vec3::Zero();
    const double least = kSingular * kSingular * svd.eigenvalues()[2];
    for (int i = 0; i < 3; ++i) {
        if (svd.eigenvalues()[i] > least) {
            shift += svd.eigenvectors().col(i) * (svd.eigenvectors().col(i).dot(rest) / svd.eigenvalues()[i]);
        }
    }
    return mean + shift;
}

}  // namespace mq::boolean
