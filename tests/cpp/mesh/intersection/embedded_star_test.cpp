// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/embedded_star.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/cases.h"
#include "mesh/intersection/all_contacts.h"
#include "mesh/intersection/tied_points.h"

namespace mq::mesh {
namespace {

/// A closed fan around vertex 0, its rim at `radius(k)` in direction `angle(k)` and height `height(k)`.
struct Fan {
    template <typename Rim>
    Fan(int count, const Rim& rim) {
        vertices.emplace_back(0, 0, 0);
        for (int k = 0; k < count; ++k) {
            vertices.push_back(rim(k));
            triangles.push_back({0, 1 + k, 1 + (k + 1) % count});
        }
    }
    bool embedded() const { return embedded_star(vertices, triangles, VertexStars(triangles, vertices.size())[0]); }

    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

Vec3 on_circle(double angle, double height) {
    return {std::cos(angle), std::sin(angle), height};
}

TEST(EmbeddedStar, HoldsForCornersOfSolids) {
    EXPECT_TRUE(Fan(6, [](int k) { return on_circle(2 * M_PI * k / 6, 0.0); }).embedded());
    EXPECT_TRUE(Fan(6, [](int k) { return on_circle(2 * M_PI * k / 6, -5.0); }).embedded());
    EXPECT_TRUE(Fan(5, [](int k) { return on_circle(2 * M_PI * k / 5, k % 2 == 0 ? 0.3 : -0.3); }).embedded());
    EXPECT_TRUE(Fan(3, [](int k) { return Vec3(Vec3::Unit(k)); }).embedded());
}

TEST(EmbeddedStar, DoesNotHoldWhereTheLinkTurnsTwiceOrFolds) {
    EXPECT_FALSE(Fan(10, [](int k) { return on_circle(4 * M_PI * k / 10, 0.1 * k); }).embedded());
    EXPECT_FALSE(Fan(4, [](int k) { return on_circle(k == 2 ? 0.1 : 2 * M_PI * k / 4, 0.0); }).embedded());
    Fan open(6, [](int k) { return on_circle(2 * M_PI * k / 6, 0.0); });
    open.triangles.pop_back();
    EXPECT_FALSE(open.embedded());
    Fan twice(3, [](int k) { return on_circle(2 * M_PI * k / 3, 0.0); });
    twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
    EXPECT_FALSE(twice.embedded());
}

TEST(EmbeddedStar, IsNeverMistaken) {
    TiedPoints point(7);
    int held = 0;
    for (int i = 0; i < scaled_cases(4000); ++i) {
        const int count = point.integer(3, 7);
        const double lift = point.integer(-2, 2);
        const Fan fan(count, [&](int k) -> Vec3 {
            if (i % 2 == 0) {
                return point() - Vec3(1.5, 1.5, 1.5);
            }
            return on_circle(2 * M_PI * k / count, lift) + 0.2 * point();
        });
        if (fan.embedded()) {
            ++held;
            EXPECT_TRUE(brute_force(fan.vertices, fan.triangles).empty()) << "case " << i;
        }
    }
    EXPECT_GT(held, scaled_cases(400));
}

}  // namespace
}  // namespace mq::mesh
