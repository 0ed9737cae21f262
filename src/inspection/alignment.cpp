// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/alignment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mq::inspection {

using geometry::RigidMotion;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

namespace {

constexpr std::size_t kFewPoints = 600;     ///< for each of the poses that principal axes propose
constexpr std::size_t kSomePoints = 4000;   ///< for the best of them
constexpr std::size_t kManyPoints = 40000;  ///< for the fit to the mesh, and first steps with exact distances
constexpr std::size_t kKeptPoses = 4;
constexpr int kPoseSteps = 12;
constexpr int kMostSteps = 100;
constexpr int kMostExactSteps = 20;
constexpr double kOutlier = 3.0;        ///< robust standard deviations
constexpr double kDeviations = 1.4826;  ///< standard deviations of a normal distribution in its median absolute value
constexpr double kRestOnMesh = 1.0;     ///< likewise with distances from facets, which are rough
constexpr double kRest = 0.05;          ///< the next step would be shorter than this fraction of its standard error
constexpr double kFinest = 1e-9;        ///< a step shorter than this fraction of the size is the last one
constexpr double kMostRms = 0.02;       ///< fraction of the size: points farther off do not fit
constexpr double kFlat = 1e-6;          ///< motions that change squared distances by less than this fraction are free
constexpr double kSame = 0.02;          ///< poses whose residuals differ by less than this fraction are equally good
constexpr double kLargestTurn = 0.3;    ///< radians in a step

std::vector<Vec3> every(const std::vector<Vec3>& points, std::size_t most) {
    std::vector<Vec3> some;
    const std::size_t count = std::min(most, points.size());
    for (std::size_t k = 0; k < count; ++k) {
        some.push_back(points[k * points.size() / count]);
    }
    return some;
}

std::vector<Vec3> moved(const std::vector<Vec3>& points, const RigidMotion& motion) {
    std::vector<Vec3> result;
    result.reserve(points.size());
    for (const Vec3& p : points) {
        result.push_back(motion.of_point(p));
    }
    return result;
}

RigidMotion after(const RigidMotion& second, const RigidMotion& first) {
    RigidMotion both;
    both.turn = second.turn * first.turn;
    both.shift = second.turn * first.shift + second.shift;
    return both;
}

double turn_of(const RigidMotion& motion) {
    return std::acos(std::clamp(0.5 * (motion.turn.trace() - 1.0), -1.0, 1.0));
}

Vec3 mean_of(const std::vector<Vec3>& points) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : points) {
        sum += p;
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, points.size()));
}

/// Principal axes in columns, those of the largest extent last; right-handed.
Eigen::Matrix3d axes_of(const std::vector<Vec3>& points, const Vec3& middle) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Vec3& p : points) {
        sum += (p - middle) * (p - middle).transpose();
    }
    Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors();
    if (axes.determinant() < 0.0) {
        axes.col(0) = -axes.col(0);
    }
    return axes;
}

/// The 24 rotations that put axes onto axes.
std::vector<Eigen::Matrix3d> turns_of_axes() {
    std::vector<Eigen::Matrix3d> turns;
    std::array<int, 3> order{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
            for (int i = 0; i < 3; ++i) {
                turn(i, order[static_cast<std::size_t>(i)]) = (signs >> i & 1) != 0 ? -1.0 : 1.0;
            }
            if (turn.determinant() > 0.0) {
                turns.push_back(turn);
            }
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return turns;
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// One step of Gauss and Newton towards the least sum of squared distances.
struct Step {
    RigidMotion motion;
    double rms = 0.0;          ///< mm, before the step
    double length = 0.0;       ///< mm: by how far it moves the points, root mean square
    double of_error = 0.0;     ///< the largest ratio of a component to its standard error
    double shift_error = 0.0;  ///< mm
    double turn_error = 0.0;   ///< radians
    double score = 0.0;        ///< mm: mean distance without the farthest fifth
    std::size_t used = 0;
    int undetermined = 0;
};

double limit_of(const std::vector<SignedDistance>& distances, double size, double& score) {
    std::vector<double> absolute;
    absolute.reserve(distances.size());
    for (const SignedDistance& d : distances) {
        absolute.push_back(std::abs(d.value));
    }
    const std::size_t kept = std::max<std::size_t>(1, absolute.size() * 4 / 5);
    const double median = median_of(absolute);
    std::nth_element(absolute.begin(), absolute.begin() + static_cast<std::ptrdiff_t>(kept - 1), absolute.end());
    score = 0.0;
    for (std::size_t k = 0; k < kept; ++k) {
        score += absolute[k] / static_cast<double>(kept);
    }
    return std::max(kOutlier * kDeviations * median, kFinest * size);
}

/// @param points  where the distances were measured
Step step_from(const std::vector<Vec3>& points, const std::vector<SignedDistance>& distances, double size,
               bool keep_all) {
    Step step;
    const double limit = keep_all ? std::numeric_limits<double>::infinity() : limit_of(distances, size, step.score);
    Vec3 middle = Vec3::Zero();
    double spread = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (std::abs(distances[k].value) <= limit) {
            ++step.used;
            middle += points[k];
            squares += distances[k].value * distances[k].value;
        }
    }
    middle /= static_cast<double>(step.used);
    for (const Vec3& p : points) {
        spread += (p - middle).squaredNorm() / static_cast<double>(points.size());
    }
    const double unit = std::max(std::sqrt(spread), kFinest * size);  // turns are measured by the way of the points
    Matrix6 normal = Matrix6::Zero();
    Vec6 right = Vec6::Zero();
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (std::abs(distances[k].value) <= limit) {
            Vec6 row;
            row << (points[k] - middle).cross(distances[k].normal) / unit, distances[k].normal;
            normal += row * row.transpose();
            right -= row * distances[k].value;
        }
    }
    const Eigen::SelfAdjointEigenSolver<Matrix6> solver(normal);
    const Vec6& values = solver.eigenvalues();
    const int freedom = std::max(1, static_cast<int>(step.used) - 6);
    step.rms = std::sqrt(squares / static_cast<double>(step.used));
    const double noise = squares / freedom;
    Vec6 move = Vec6::Zero();
    for (int i = 0; i < 6; ++i) {
        if (values[i] <= kFlat * values[5]) {
            ++step.undetermined;
            continue;
        }
        const Vec6 axis = solver.eigenvectors().col(i);
        const double along = axis.dot(right) / values[i];
        move += along * axis;
        step.of_error = std::max(step.of_error, std::abs(along) / std::sqrt(noise / values[i] + 1e-300));
        step.turn_error += noise / values[i] * axis.head<3>().squaredNorm() / (unit * unit);
        step.shift_error += noise / values[i] * axis.tail<3>().squaredNorm();
    }
    step.turn_error = std::sqrt(step.turn_error);
    step.shift_error = std::sqrt(step.shift_error);
    step.length = move.norm();
    const Vec3 turn = move.head<3>() / unit;
    const double angle = turn.norm(), scale = angle > kLargestTurn ? kLargestTurn / angle : 1.0;
    if (angle > 0.0) {
        step.motion.turn = Eigen::AngleAxisd(scale * angle, Eigen::Vector3d(turn / angle)).toRotationMatrix();
    }
    step.motion.shift = middle - step.motion.turn * middle + Vec3(scale * move.tail<3>());
    return step;
}

class Fit {
  public:
    Fit(const AlignmentTarget& target, Progress& progress) : target_(target), progress_(progress) {}

    /// Steps until the next one would be shorter than a fraction of its standard error, `most` at most; returns the
    /// last one. Each step is expected to be as much shorter than the one before as that one was.
    Step run(const std::vector<Vec3>& points, const DistancesOf& distances_of, int most, double rest, bool keep_all,
             Alignment& found) const {
        Step step;
        double before = 0.0;
        found.converged = false;
        for (int i = 0; i < most && !found.converged; ++i) {
            progress_.check();
            const std::vector<Vec3> now = moved(points, found.motion);
            step = step_from(now, distances_of(now), target_.size, keep_all);
            ++found.iterations;
            // What is kept whole comes to lie on the reference, and no scatter says when it is near enough.
            const double shorter = !keep_all && before > step.length ? step.length / before : 1.0;
            before = step.length;
            found.converged = shorter * step.of_error <= rest || step.length <= kFinest * target_.size;
            found.motion = after(step.motion, found.motion);
        }
        found.rms = step.rms;
        found.used = step.used;
        found.points = points.size();
        found.shift_error = step.shift_error;
        found.turn_error = step.turn_error;
        found.undetermined = step.undetermined;
        return step;
    }

    /// The best pose of those that principal axes propose, and of the given one.
    RigidMotion best_pose(const std::vector<Vec3>& points) const {
        const std::vector<Vec3> few = every(points, kFewPoints), some = every(points, kSomePoints);
        const Vec3 from = mean_of(points), to = mean_of(target_.surface);
        const Eigen::Matrix3d axes = axes_of(points, from), target_axes = axes_of(target_.surface, to);
        std::vector<RigidMotion> starts(2);
        starts[1].shift = to - from;
        for (const Eigen::Matrix3d& turn : turns_of_axes()) {
            RigidMotion& start = starts.emplace_back();
            start.turn = target_axes * turn * axes.transpose();
            start.shift = to - start.turn * from;
        }
        std::vector<Pose> poses;
        for (const RigidMotion& start : starts) {
            poses.push_back(improved(few, start, kPoseSteps));
        }
        std::stable_sort(poses.begin(), poses.end(), [](const Pose& a, const Pose& b) { return a.score < b.score; });
        poses.resize(std::min(poses.size(), kKeptPoses));
        for (Pose& pose : poses) {
            pose = improved(some, pose.motion, kMostSteps / 2);
        }
        const double least = std::min_element(poses.begin(), poses.end(), [](const Pose& a, const Pose& b) {
                                 return a.score < b.score;
                             })->score;
        const double enough = least * (1.0 + kSame) + kFinest * target_.size;
        const Pose* best = nullptr;
        for (const Pose& pose : poses) {
            if (pose.score <= enough && (best == nullptr || turn_of(pose.motion) < turn_of(best->motion))) {
                best = &pose;
            }
        }
        return best->motion;
    }

  private:
    struct Pose {
        RigidMotion motion;
        double score = 0.0;
    };

    Pose improved(const std::vector<Vec3>& points, const RigidMotion& start, int steps) const {
        Alignment found;
        found.motion = start;
        const Step last = run(points, target_.by_mesh, steps, kRestOnMesh, false, found);
        return {found.motion, last.score};
    }

    const AlignmentTarget& target_;
    Progress& progress_;
};

}  // namespace

RigidMotion motion_of(const std::vector<PointPair>& pairs) {
    std::vector<Vec3> from, to;
    for (const PointPair& pair : pairs) {
        from.push_back(pair[0]);
        to.push_back(pair[1]);
    }
    const Vec3 a = mean_of(from), b = mean_of(to);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const PointPair& pair : pairs) {
        sum += (pair[1] - b) * (pair[0] - a).transpose();
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs(1.0, 1.0, 1.0);
    signs[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    RigidMotion motion;
    motion.turn = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    motion.shift = b - motion.turn * a;
    return motion;
}

Alignment align(const std::vector<Vec3>& points, const AlignmentTarget& target, Align how,
                const std::vector<PointPair>& pairs, Progress& progress) {
    Alignment found;
    const Fit fit(target, progress);
    if (how == Align::None) {
        found.converged = true;
        return found;
    }
    if (how == Align::Pairs || how == Align::ThreeTwoOne) {
        found.motion = motion_of(pairs);
    }
    if (how == Align::ThreeTwoOne) {
        std::vector<Vec3> own;
        for (const PointPair& pair : pairs) {
            own.push_back(pair[0]);
        }
        fit.run(own, target.exact, kMostSteps, kRest, true, found);
    } else {
        if (how == Align::Any) {
            found.motion = fit.best_pose(points);
        }
        progress.advance(0.3);
        fit.run(every(points, kManyPoints), target.by_mesh, kMostSteps, kRestOnMesh, false, found);
        progress.advance(0.6);
        if (found.converged && found.rms <= kMostRms * target.size) {
            // Steps from the mesh's fit are long ones, for which some points are enough.
            if (points.size() > kManyPoints) {
                fit.run(every(points, kManyPoints), target.exact, kMostExactSteps, kRest, false, found);
            }
            fit.run(points, target.exact, kMostExactSteps, kRest, false, found);
        }
    }
    found.converged = found.converged && found.rms <= kMostRms * target.size;
    return found;
}

}  // namespace mq::inspection
