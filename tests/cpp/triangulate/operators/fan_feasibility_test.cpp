// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/fan_feasibility.h"

#include <random>

#include "base/angle.h"
#include "triangulate/ring_mesh.h"

/// Feasibility of fans, judged by the corners and the sides of a disc's boundary.
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

/// A rectangle of 10 x 1 around its middle, whose corners lie above and below its plane by `bend` in turn. From the
/// middle the long sides are seen at 11.3 degrees at their ends at most.
ClassifiedMesh rectangle(double bend) {
    return ring_mesh({Vec3(5, 0.5, bend), Vec3(-5, 0.5, -bend), Vec3(-5, -0.5, bend), Vec3(5, -0.5, -bend)},
                     Vec3::Zero());
}

TEST(FanFeasibility, LeaveNoRoomBetweenSidesThatAreTooLong) {
    for (const double bend : {0.0, 0.01, 0.02}) {
        const ClassifiedMesh mesh = rectangle(bend);
        const auto disc = disc_of(mesh, triangles_around(mesh, 2));
        ASSERT_TRUE(disc);
        const FanFeasibility wide(mesh, *disc, 5.0 * kDegree);
        EXPECT_TRUE(wide.allow_inner_apex()) << bend;
        EXPECT_EQ(wide.blocking_side(), -1) << bend;
        const FanFeasibility none(mesh, *disc, 25.0 * kDegree);
        EXPECT_FALSE(none.allow_inner_apex()) << bend;
        ASSERT_GE(none.blocking_side(), 0) << bend;
        const int side = disc->rim[static_cast<std::size_t>(none.blocking_side())];
        EXPECT_EQ(mesh.point_of(side).y(), mesh.point_of(ClassifiedMesh::next(side)).y()) << "a short side, " << bend;
    }
}

/// Far from plane nothing can be told of the sides.
TEST(FanFeasibility, AllowWhatIsBentTooMuch) {
    const ClassifiedMesh mesh = rectangle(1.0);
    const auto disc = disc_of(mesh, triangles_around(mesh, 2));
    ASSERT_TRUE(disc);
    EXPECT_EQ(FanFeasibility(mesh, *disc, 25.0 * kDegree).blocking_side(), -1);
    EXPECT_EQ(FanFeasibility(mesh, *disc, 0.0).blocking_side(), -1);
}

/// An angle that is too small is found out early, one that is large enough is exact.
TEST(FanFeasibility, AreNotNeededForTheAngleOfAFan) {
    const ClassifiedMesh mesh = rectangle(0.0);
    const auto disc = disc_of(mesh, triangles_around(mesh, 2));
    ASSERT_TRUE(disc);
    const double angle = fan_angle(mesh, *disc, Vec3::Zero());
    EXPECT_NEAR(angle, std::atan(0.1), 1e-12);
    EXPECT_EQ(fan_angle(mesh, *disc, Vec3::Zero(), -1, angle), angle);
    EXPECT_EQ(fan_angle(mesh, *disc, Vec3::Zero(), -1, 1.001 * angle), -1.0);
    EXPECT_EQ(fan_angle(mesh, *disc, Vec3(6.0, 0.0, 0.0)), -1.0);
}

}  // namespace
}  // namespace mq::triangulate
