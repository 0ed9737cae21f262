// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "inspection/deviation.h"
#include "inspection/solids.h"

namespace mq::inspection {
namespace {

/// A block with a step, which no turn puts onto itself.
mesh::TriangleMesh stepped_block() {
    mesh::TriangleMesh block = solids::box(Vec3(0, 0, 0), Vec3(8, 5, 2));
    solids::add(block, solids::box(Vec3(0, 0, 3), Vec3(3, 2, 5)));
    return block;
}

/// Points of its triangles, with a normal deviate of `noise` along each axis.
std::vector<Vec3> scan_of(const mesh::TriangleMesh& mesh, int count, double noise) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> deviate(0.0, 1.0);
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k) {
        const mesh::Triangle& t = mesh.triangles[static_cast<std::size_t>(k) % mesh.triangles.size()];
        double a = share(random), b = share(random);
        if (a + b > 1.0) {
            a = 1.0 - a;
            b = 1.0 - b;
        }
        const Vec3& p = mesh.vertices[static_cast<std::size_t>(t[0])];
        const Vec3 on = p + a * (mesh.vertices[static_cast<std::size_t>(t[1])] - p) +
                        b * (mesh.vertices[static_cast<std::size_t>(t[2])] - p);
        points.push_back(on + noise * Vec3(deviate(random), deviate(random), deviate(random)));
    }
    return points;
}

geometry::RigidMotion motion(const Vec3& axis, double angle, const Vec3& shift) {
    geometry::RigidMotion found;
    found.turn = Eigen::AngleAxisd(angle, Eigen::Vector3d(axis.normalized())).toRotationMatrix();
    found.shift = shift;
    return found;
}

double farthest(const std::vector<Vec3>& points, const std::vector<Vec3>& moved, const geometry::RigidMotion& back) {
    double most = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        most = std::max(most, (back.of_point(moved[k]) - points[k]).norm());
    }
    return most;
}

std::vector<Vec3> moved_by(const std::vector<Vec3>& points, const geometry::RigidMotion& away) {
    std::vector<Vec3> moved;
    for (const Vec3& p : points) {
        moved.push_back(away.of_point(p));
    }
    return moved;
}

TEST(Alignment, FindsAnyPoseOfPointsWithoutNoise) {
    const mesh::TriangleMesh block = stepped_block();
    const std::vector<Vec3> points = scan_of(block, 4000, 0.0);
    for (const double angle : {0.1, 1.0, 2.0, 3.1}) {
        const std::vector<Vec3> moved = moved_by(points, motion(Vec3(1, 2, -1), angle, Vec3(30, -20, 5)));
        DeviationOptions options;
        options.align = Align::Any;
        Progress progress;
        const Deviation found = measure_deviation(moved, block, nullptr, 0.0, options, progress);
        ASSERT_TRUE(found.alignment.converged) << angle;
        EXPECT_LT(farthest(points, moved, found.alignment.motion), 1e-9) << angle;
    }
}

TEST(Alignment, ErrsByNoMoreThanItsStandardErrorSays) {
    const mesh::TriangleMesh block = stepped_block();
    const double noise = 0.01;
    const std::vector<Vec3> points = scan_of(block, 100000, noise);
    std::vector<Vec3> moved = moved_by(points, motion(Vec3(0, 1, 1), 0.7, Vec3(1, 2, 3)));
    for (std::size_t k = 0; k < moved.size(); k += 20) {
        moved[k] += Vec3(1.0, 0.5, -0.5);  // outliers
    }
    DeviationOptions options;
    options.align = Align::Any;
    Progress progress;
    const Deviation found = measure_deviation(moved, block, nullptr, 0.0, options, progress);
    ASSERT_TRUE(found.alignment.converged);
    EXPECT_NEAR(found.alignment.rms, noise, 0.1 * noise);
    EXPECT_LT(found.alignment.shift_error, 0.02 * noise);
    const Vec3 middle(4, 2.5, 2);
    const Vec3 there = motion(Vec3(0, 1, 1), 0.7, Vec3(1, 2, 3)).of_point(middle);
    EXPECT_LT((found.alignment.motion.of_point(there) - middle).norm(), 4.0 * found.alignment.shift_error);
}

TEST(Alignment, LeavesTheTurnOfASphereAsItIs) {
    const mesh::TriangleMesh ball = solids::sphere(5.0, 5);
    const std::vector<Vec3> points = scan_of(ball, 5000, 0.0);
    DeviationOptions options;
    options.align = Align::Near;
    Progress progress;
    const Deviation found = measure_deviation(moved_by(points, motion(Vec3(1, 0, 0), 0.0, Vec3(0.3, 0, 0))), ball,
                                              nullptr, 0.0, options, progress);
    EXPECT_TRUE(found.alignment.converged);
    EXPECT_NEAR(found.alignment.motion.shift.x(), -0.3, 1e-3);
}

TEST(Alignment, DoesNotConvergeWhereThePointsAreOfAnotherShape) {
    const std::vector<Vec3> points = scan_of(solids::sphere(5.0, 4), 3000, 0.0);
    DeviationOptions options;
    options.align = Align::Any;
    Progress progress;
    const Deviation found = measure_deviation(points, stepped_block(), nullptr, 0.0, options, progress);
    EXPECT_FALSE(found.alignment.converged);
    EXPECT_TRUE(found.distances.empty());
}

TEST(Alignment, PutsSixPointsOntoThreeFaces) {
    const mesh::TriangleMesh block = solids::box(Vec3(0, 0, 0), Vec3(8, 5, 2));
    const std::vector<Vec3> on{{1, 1, 0}, {7, 1, 0}, {4, 4, 0}, {1, 0, 1}, {7, 0, 1}, {0, 2, 1}};
    const std::vector<Vec3> moved = moved_by(on, motion(Vec3(1, 1, 1), 0.5, Vec3(3, -1, 7)));
    DeviationOptions options;
    options.align = Align::ThreeTwoOne;
    for (std::size_t k = 0; k < on.size(); ++k) {
        // Picked by hand, half a millimetre beside the place.
        options.pairs.push_back({moved[k], on[k] + 0.5 * Vec3(std::cos(k), std::sin(k), std::cos(2.0 * k))});
    }
    Progress progress;
    const Deviation found = measure_deviation(moved, block, nullptr, 0.0, options, progress);
    ASSERT_TRUE(found.alignment.converged);
    EXPECT_LT(farthest(on, moved, found.alignment.motion), 1e-9);
}

TEST(Alignment, OfPairsIsTheirMotion) {
    const geometry::RigidMotion away = motion(Vec3(3, -1, 2), 2.5, Vec3(4, 5, 6));
    std::vector<PointPair> pairs;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(1, 1, 3)}) {
        pairs.push_back({p, away.of_point(p)});
    }
    const geometry::RigidMotion found = motion_of(pairs);
    EXPECT_LT((found.turn - away.turn).norm(), 1e-12);
    EXPECT_LT((found.shift - away.shift).norm(), 1e-12);
}

}  // namespace
}  // namespace mq::inspection
