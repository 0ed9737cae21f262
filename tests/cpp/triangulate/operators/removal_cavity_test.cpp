// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/removal_cavity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "triangulate/ring_mesh.h"

namespace mq::triangulate {
namespace {

ClassifiedMesh hexagon() {
    std::vector<Vec3> corners;
    for (int i = 0; i < 6; ++i) {
        corners.emplace_back(std::cos(M_PI * i / 3.0), std::sin(M_PI * i / 3.0), 0.0);
    }
    return ring_mesh(corners, Vec3(0.2, 0.1, 0.0));
}

TEST(RemovalCavity, OfAVertexInsideIsTheRingAroundIt) {
    const ClassifiedMesh mesh = hexagon();
    const auto cavity = removal_cavity(mesh, 2);
    ASSERT_TRUE(cavity);
    EXPECT_EQ(cavity->triangles.size(), 6u);
    EXPECT_EQ(cavity->sides.size(), 6u);
    EXPECT_EQ(cavity->base[0], -1) << "the vertex is on no edge";
    EXPECT_NEAR(cavity->normal.z(), 3.0 * std::sqrt(3.0), 1e-12);
}

TEST(RemovalCavity, FansOfARegularHexagonHave30Degrees) {
    const ClassifiedMesh mesh = hexagon();
    const auto cavity = removal_cavity(mesh, 2);
    ASSERT_TRUE(cavity);
    const std::vector<Fan> fans = fans_of(mesh, *cavity, 0.0);
    ASSERT_EQ(fans.size(), 6u);
    std::set<int> apexes;
    for (const Fan& fan : fans) {
        EXPECT_NEAR(fan.angle, M_PI / 6.0, 1e-12);
        EXPECT_EQ(fan.triangles.size(), 4u);
        apexes.insert(fan.apex_site);
        EXPECT_TRUE(fan_aligned(mesh, *cavity, fan, kAligned));
        EXPECT_EQ(spokes_of(*cavity, fan.apex_site).size(), 3u);
    }
    EXPECT_EQ(apexes.size(), 6u);
    EXPECT_TRUE(fans_of(mesh, *cavity, M_PI / 5.0).empty());
}

TEST(RemovalCavity, AFanThatDoublesAnEdgeIsNotLegal) {
    ClassifiedMesh mesh = hexagon();
    MaxMinSwaps maxmin(mesh);
    const auto cavity = removal_cavity(mesh, 2);
    ASSERT_TRUE(cavity);
    for (const Fan& fan : fans_of(mesh, *cavity, 0.0)) {
        EXPECT_TRUE(fan_legal(mesh, maxmin, *cavity, fan.apex_site)) << "no edge joins corners of the ring yet";
    }
}

}  // namespace
}  // namespace mq::triangulate
