// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/vec.h"

namespace mq::layered_depth {

/// The quadratic error function of Hermite data (Wang 2010, section III-A; Ju et al. 2002): the sum over all planes of
/// the squared distance.
class Quadric {
  public:
    void add(const Vec3& point, const Vec3& normal);
    int count() const { return count_; }
    /// The point of least error within a box, by singular value decomposition. If several points have the least error
    /// (on a plane or a straight edge), the one nearest to the mean of the samples. If nearly parallel planes meet far
    /// outside of the box, the smallest singular value is taken as zero, then the next one: the mean itself is always
    /// an answer. Needs at least one sample.
    Vec3 minimiser(const Vec3& low, const Vec3& high) const;

  private:
    Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();  // sum of n n^T
    Vec3 moment_ = Vec3::Zero();                        // sum of n (n . h)
    Vec3 sum_ = Vec3::Zero();
    int count_ = 0;
};

}  // namespace mq::layered_depth
