// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/fan_feasibility.h"

#include <random>

#include "base/angle.h"
#include "triangulate/ring_mesh.h"

/// Feasibility of fans, judged by the corners of a disc's boundary.
namespace mq::triangulate {
namespace {

/// A star of random radii on a dome that falls by `bend` at the distance 1.
ClassifiedMesh random_star(std::mt19937& dice, int corners, double bend) {
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<Vec3> ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * M_PI * (i + 0.8 * part(dice)) / corners;
        const double radius = 0.4 + 1.2 * part(dice);
        ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle), -bend * radius * radius);
    }
    return ring_mesh(ring, Vec3::Zero());
}

/// Bent by up to 48 degrees from the middle to the farthest corners.
TEST(FanFeasibility, AllowEveryFanThatThereIs) {
    std::mt19937 dice(7);
    int inner = 0;
    int from_rim = 0;
    for (int n = 0; n < 3000; ++n) {
        SCOPED_TRACE(n);
        const ClassifiedMesh mesh = random_star(dice, 3 + n % 8, 0.35 * (n % 5) / 4.0);
        const auto disc = disc_of(mesh, triangles_around(mesh, 2));
        if (!disc) {
            continue;  // small angles between segments
        }
        const double angle = fan_angle(mesh, *disc, best_apex(mesh, *disc));
        if (angle > 0.0) {
            EXPECT_TRUE(FanFeasibility(mesh, *disc, angle).allow_inner_apex()) << angle / kDegree;
            ++inner;
        }
        for (std::size_t k = 0; k < disc->rim.size(); ++k) {
            const int h = disc->rim[k];
            const double of_corner = fan_angle(mesh, *disc, mesh.point_of(h), mesh.site_of(h));
            if (of_corner > 0.0) {
                EXPECT_TRUE(FanFeasibility(mesh, *disc, of_corner).allow_apex(k)) << of_corner / kDegree;
                ++from_rim;
            }
        }
    }
    EXPECT_GT(inner, 1000);
    EXPECT_GT(from_rim, 1000);
}

/// A kite with a corner of 37 degrees, and those of 106 beside it.
TEST(FanFeasibility, LeaveNoRoomForASpokeInANarrowOne) {
    const ClassifiedMesh mesh =
        ring_mesh({Vec3(3, 0, 0), Vec3(0, 1, 0), Vec3(-0.4, 0, 0), Vec3(0, -1, 0)}, Vec3::Zero());
    const auto disc = disc_of(mesh, triangles_around(mesh, 2));
    ASSERT_TRUE(disc);
    EXPECT_TRUE(FanFeasibility(mesh, *disc, 15.0 * kDegree).allow_inner_apex());
    const FanFeasibility corners(mesh, *disc, 25.0 * kDegree);
    EXPECT_FALSE(corners.allow_inner_apex());
    for (std::size_t k = 0; k < disc->rim.size(); ++k) {
        const double x = mesh.point_of(disc->rim[k]).x();
        EXPECT_EQ(corners.allow_apex(k), x >= 0.0) << x;  // a spoke from the opposite corner would end in it
    }
}

/// A rectangle of 10 x 1, whose corners are wide: from its ends the long sides are seen at 11.3 degrees at most. Bent
/// by the arc's height `bend` along it, it is the same as long as the bend is small.
TEST(FanFeasibility, LeaveNoRoomBetweenSidesThatAreTooLong) {
    for (const double bend : {0.0, 0.01, 0.02}) {
        const ClassifiedMesh mesh = ring_mesh(
            {Vec3(5, 0.5, -bend), Vec3(-5, 0.5, -bend), Vec3(-5, -0.5, -bend), Vec3(5, -0.5, -bend)}, Vec3(0, 0, 0));
        const auto disc = disc_of(mesh, triangles_around(mesh, 2));
        ASSERT_TRUE(disc);
        EXPECT_TRUE(FanFeasibility(mesh, *disc, 5.0 * kDegree).allow_inner_apex()) << bend;
        EXPECT_FALSE(FanFeasibility(mesh, *disc, 25.0 * kDegree).allow_inner_apex()) << bend;
    }
}

}  // namespace
}  // namespace mq::triangulate
