// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/point_octree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "triangulate/random_points.h"

namespace mq::triangulate {
namespace {

TEST(PointOctree, MissesNoPoint) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> exponent(-4.0, 1.0);
    const std::vector<Vec3> points = random_points(800, 4);
    PointOctree index;
    for (const Vec3& p : points) {
        index.add(p, std::pow(10.0, exponent(random)));
    }
    for (const Vec3& centre : random_points(50, 6)) {
        const double radius = std::pow(10.0, exponent(random));
        std::set<int> found;
        index.any_near(centre, radius, [&](int i) {
            EXPECT_TRUE(found.insert(i).second) << "visited twice";
            return false;
        });
        for (int i = 0; i < static_cast<int>(points.size()); ++i) {
            if ((points[i] - centre).norm() <= radius) {
                EXPECT_EQ(found.count(i), 1u);
            }
        }
    }
}

}  // namespace
}  // namespace mq::triangulate
