// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "base/progress.h"
#include "geometry/rigid_motion.h"
#include "inspection/mesh_distance.h"

namespace mq::inspection {

/// The signed distances of points, in their order.
using DistancesOf = std::function<std::vector<SignedDistance>(const std::vector<Vec3>&)>;

/// How points are aligned with a reference before they are measured.
enum class Align {
    None,        ///< they are measured where they are
    Near,        ///< best fit from where they are
    Any,         ///< best fit from any pose: by principal axes first
    Pairs,       ///< best fit from the pose that given pairs of points say
    ThreeTwoOne  ///< to given pairs, of which the first points lie on the reference in the end: three, two and one on
                 ///< three faces for a rigid fit
};

/// A pair of points: one of the scan, and where it belongs on the reference.
using PointPair = std::array<Vec3, 2>;

/// The motion that puts points onto a reference.
struct Alignment {
    geometry::RigidMotion motion;
    double rms = 0.0;        ///< mm: root mean square of the distances of the points that were used
    std::size_t used = 0;    ///< points that were used in the last step; the others are outliers
    std::size_t points = 0;  ///< points of the last step
    int iterations = 0;
    double shift_error = 0.0;  ///< mm: standard error of the translation (root of the sum of squares of three)
    double turn_error = 0.0;   ///< radians: likewise of the rotation
    int undetermined = 0;      ///< motions that change no distance, such as turns of a cylinder about its axis
    bool converged = false;
};

/// What points are aligned with.
struct AlignmentTarget {
    DistancesOf by_mesh;  ///< to its mesh: fast
    DistancesOf exact;
    std::vector<Vec3> surface;  ///< points spread evenly over it
    double size = 0.0;          ///< mm, the largest dimension
};

/// The rotation and translation that put the first points of pairs nearest to the second ones, by least squares (Kabsch
/// 1976; Umeyama 1991).
geometry::RigidMotion motion_of(const std::vector<PointPair>& pairs);

/// Fits points to a reference by least squares of their distances along its normals (Chen and Medioni 1992), where
/// points farther off than three robust standard deviations are left out of each step (Chetverikov et al. 2005). First
/// steps take some of the points, with distances from the mesh and then exact ones; the last ones take all points.
/// @param points  in an order in which neighbours are near each other, so that every n-th is spread evenly
/// @returns not converged where the points do not come to rest, or lie farther off than a fiftieth of the size (rms)
/// @throws Cancelled
Alignment align(const std::vector<Vec3>& points, const AlignmentTarget& target, Align how,
                const std::vector<PointPair>& pairs, Progress& progress);

}  // namespace mq::inspection
