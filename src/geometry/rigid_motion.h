// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/vec.h"

namespace mq::geometry {

/// A rigid motion: a rotation about the origin, then a translation.
struct RigidMotion {
    using Turn = Eigen::Matrix<double, 3, 3, Eigen::DontAlign>;
    Turn turn = Turn::Identity();
    Vec3 shift = Vec3::Zero();

    bool operator==(const RigidMotion& other) const { return turn == other.turn && shift == other.shift; }
    bool operator!=(const RigidMotion& other) const { return !(*this == other); }

    Vec3 of_point(const Vec3& p) const { return turn * p + shift; }
    Vec3 of_direction(const Vec3& d) const { return turn * d; }
    /// The motion from the placement `from` to the placement `to`; exactly the identity where these are equal.
    static RigidMotion between(const RigidMotion& from, const RigidMotion& to) {
        if (from == to) {
            return {};
        }
        const Turn turn = to.turn * from.turn.transpose();
        return {turn, to.shift - turn * from.shift};
    }
};

}  // namespace mq::geometry
