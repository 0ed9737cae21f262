// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/front/void_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// The search for gaps, the cells that it visits, and their outline, each compared with brute force.
namespace mq::triangulate {
namespace {

constexpr std::array<double, 3> kRadii{0.3, 0.4, 0.5};  // mm: radii at the corners, which differ.
const std::array<Vec3, 3> kTriangle{Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.2), Vec3(0.3, 0.9, -0.1)};

Vec3 point_at(const Vec2& place) {
    return kTriangle[0] + place.x() * (kTriangle[1] - kTriangle[0]) + place.y() * (kTriangle[2] - kTriangle[0]);
}

double radius_at(const Vec2& place) {
    return kRadii[0] + place.x() * (kRadii[1] - kRadii[0]) + place.y() * (kRadii[2] - kRadii[0]);
}

bool covered(const Vec2& place, const std::vector<VoidSearch::Ball>& balls) {
    return std::any_of(balls.begin(), balls.end(), [&](const VoidSearch::Ball& b) {
        return (point_at(place) - b.centre).norm() < (b.radius > 0.0 ? b.radius : radius_at(place));
    });
}

std::vector<VoidSearch::Ball> random_balls(int count, std::mt19937_64& random) {
    std::vector<VoidSearch::Ball> balls;
    for (int i = 0; i < count; ++i) {
        const Vec2 place(1.4 * uniform(random) - 0.2, 1.4 * uniform(random) - 0.2);
        const Vec3 lift(0.0, 0.0, 0.2 * uniform(random) - 0.1);
        balls.push_back({point_at(place) + lift, i % 4 == 0 ? 0.35 : 0.0});
    }
    return balls;
}

// Returns the fraction of a fine grid that no ball covers.
double free_share(const std::vector<VoidSearch::Ball>& balls) {
    constexpr int kGridSteps = 200;  // Steps of the grid along each side.
    int free = 0;
    for (int i = 0; i < kGridSteps; ++i) {
        for (int j = 0; i + j < kGridSteps; ++j) {
            free += covered(Vec2((i + 1.0 / 3.0) / kGridSteps, (j + 1.0 / 3.0) / kGridSteps), balls) ? 0 : 1;
        }
    }
    return free / (0.5 * kGridSteps * (kGridSteps + 1));
}

TEST(VoidSearch, FindsOnlyGapsAndMissesNoLargeOne) {
    std::mt19937_64 random(11);
    const VoidSearch::Outline all{{}, Vec2(0.3, 0.3), true};
    int gaps = 0;
    int none = 0;
    for (int run = 0; run < 400; ++run) {
        const auto balls = random_balls(4 + run % 12, random);
        const auto place = VoidSearch(kTriangle, kRadii, balls, all).find(0.02, random);
        if (place) {
            ++gaps;
            EXPECT_GE(place->minCoeff(), 0.0);
            EXPECT_LE(place->sum(), 1.0);
            EXPECT_FALSE(covered(*place, balls));
        } else {
            ++none;
            EXPECT_LT(free_share(balls), 1e-3);
        }
    }
    EXPECT_GT(gaps, 50);
    EXPECT_GT(none, 50);
}

TEST(VoidSearch, DartsAreEvenlyDistributedOverTheGap) {
    std::mt19937_64 random(12);
    const std::vector<VoidSearch::Ball> balls{{point_at({0.2, 0.2}), 0.3}, {point_at({0.8, 0.1}), 0.2}};
    const VoidSearch::Outline all{{}, Vec2(0.3, 0.3), true};
    VoidSearch search(kTriangle, kRadii, balls, all);
    constexpr int kDarts = 20000;  // Darts, for a mean with an error below the tolerance.
    Vec2 sum = Vec2::Zero();
    for (int i = 0; i < kDarts; ++i) {
        sum += *search.find(0.02, random);
    }
    Vec2 expected = Vec2::Zero();
    int free = 0;
    for (int i = 0; i < 400; ++i) {
        for (int j = 0; i + j < 400; ++j) {
            const Vec2 place((i + 1.0 / 3.0) / 400.0, (j + 1.0 / 3.0) / 400.0);
            if (!covered(place, balls)) {
                expected += place;
                ++free;
            }
        }
    }
    EXPECT_NEAR((sum / kDarts - expected / free).norm(), 0.0, 0.01);
}

TEST(VoidSearch, LooksOnlyInsideOfTheOutline) {
    std::mt19937_64 random(13);
    // The region with x + 2 y > 0.5, without any ball.
    const VoidSearch::Outline half{{{Vec2(0.5, 0.0), Vec2(0.0, 0.25)}}, Vec2(0.4, 0.4), true};
    VoidSearch search(kTriangle, kRadii, {}, half);
    for (int i = 0; i < 1000; ++i) {
        const auto place = search.find(0.02, random);
        ASSERT_TRUE(place);
        EXPECT_GT(place->x() + 2.0 * place->y(), 0.5);
    }
    const VoidSearch::Outline nothing{{}, Vec2(0.4, 0.4), false};
    EXPECT_FALSE(VoidSearch(kTriangle, kRadii, {}, nothing).find(0.02, random));
}

TEST(VoidSearch, ATriangleWithoutAreaHasNoGap) {
    std::mt19937_64 random(14);
    const std::array<Vec3, 3> line{Vec3::Zero(), Vec3::UnitX(), Vec3(0.5, 0.0, 0.0)};
    EXPECT_FALSE(VoidSearch(line, kRadii, {}, {{}, Vec2(0.3, 0.3), true}).find(0.02, random));
}

TEST(Outline, MeetsIsExactOnTheBorder) {
    const Triangle2 t{Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0)};
    const Triangle2 turned{t[0], t[2], t[1]};
    for (const Triangle2& triangle : {t, turned}) {
        EXPECT_TRUE(meets(triangle, {Vec2(0.1, 0.1), Vec2(0.2, 0.2)})) << "within";
        EXPECT_TRUE(meets(triangle, {Vec2(-1.0, 0.3), Vec2(2.0, 0.3)})) << "through";
        EXPECT_TRUE(meets(triangle, {Vec2(1.0, 0.0), Vec2(2.0, 0.0)})) << "in a corner";
        EXPECT_TRUE(meets(triangle, {Vec2(0.0, 1.0), Vec2(1.0, 0.0)})) << "along a side";
        EXPECT_FALSE(meets(triangle, {Vec2(0.6, 0.5), Vec2(0.5, 0.6)})) << "beside a side";
        EXPECT_FALSE(meets(triangle, {Vec2(-0.5, 0.4), Vec2(0.4, -0.5)})) << "past a corner";
    }
}

TEST(Outline, CrossingsTellInsideFromOutside) {
    std::mt19937_64 random(15);
    std::vector<Segment2> star;   // corners with radii between 0.4 and 1
    constexpr int kCorners = 24;  // Corners of a star, every other one on the inner radius.
    const auto corner = [](int k) {
        const double radius = k % 2 == 0 ? 1.0 : 0.4;
        const double angle = 2.0 * M_PI * k / kCorners;
        return Vec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int k = 0; k < kCorners; ++k) {
        star.push_back({corner(k), corner((k + 1) % kCorners)});
    }
    for (int i = 0; i < 2000; ++i) {
        const Vec2 p(2.4 * uniform(random) - 1.2, 2.4 * uniform(random) - 1.2);
        const auto crossings =
            std::count_if(star.begin(), star.end(), [&](const Segment2& s) { return crosses(Vec2(0.01, 0.02), p, s); });
        if (p.norm() < 0.38) {
            EXPECT_EQ(crossings % 2, 0);
        } else if (p.norm() > 1.0) {
            EXPECT_EQ(crossings % 2, 1);
        }
    }
}

}  // namespace
}  // namespace mq::triangulate
