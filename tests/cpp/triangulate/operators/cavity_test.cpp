// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/cavity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "triangulate/ring_mesh.h"

namespace mq::triangulate {
namespace {

/// A regular polygon with its corners joined to a point inside.
ClassifiedMesh polygon(int corners, const Vec3& inside) {
    std::vector<Vec3> ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * M_PI * i / corners;
        ring.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    return ring_mesh(ring, inside);
}

TEST(Cavity, OfAllTrianglesAroundAVertexHasTheRingAsItsRim) {
    const ClassifiedMesh mesh = polygon(6, Vec3(0.3, 0.1, 0));
    const auto disc = disc_of(mesh, triangles_around(mesh, 2));
    ASSERT_TRUE(disc);
    EXPECT_EQ(disc->triangles.size(), 6u);
    EXPECT_EQ(disc->rim.size(), 6u);
    EXPECT_NEAR(disc->normal.z(), 2.0 * 1.5 * std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(smallest_angle(mesh, *disc), fan_angle(mesh, *disc, Vec3(0.3, 0.1, 0)), 1e-12);
}

TEST(Cavity, IsNoneWhereTrianglesDoNotHangTogether) {
    const ClassifiedMesh mesh = polygon(8, Vec3(0, 0, 0));
    EXPECT_TRUE(disc_of(mesh, {0, 1, 2}));
    EXPECT_FALSE(disc_of(mesh, {0, 4}));  // they share one vertex, which would be on the boundary twice
}

/// By numbers of corners, sides and triangles a ring is a disc if one of its vertices has two sites.
TEST(Cavity, IsNoneWhereAVertexHasTwoSites) {
    for (const bool two_sites : {false, true}) {
        ClassifiedMesh mesh;
        const Vec3 up(0, 0, 1);
        std::array<std::vector<int>, 2> sites;
        for (std::size_t ring = 0; ring < 2; ++ring) {
            for (int i = 0; i < 4; ++i) {
                const double angle = 0.5 * M_PI * (i + 0.5 * static_cast<double>(ring));
                const Vec3 p = (ring == 0 ? 2.0 : 1.0) * Vec3(std::cos(angle), std::sin(angle), 0.0);
                sites[ring].push_back(mesh.add_site({mesh.add_vertex(p, {1, i}), p.head<2>(), up}));
            }
        }
        const ClassifiedMesh::VertexUse& first = mesh.site(sites[0][0]);
        const int last = two_sites ? mesh.add_site({first.vertex, Vec2(9, 9), up}) : sites[0][0];
        std::vector<int> triangles;
        for (int i = 0; i < 4; ++i) {
            const int next = i < 3 ? sites[0][i + 1] : last;
            triangles.push_back(mesh.add_triangle({sites[0][i], next, sites[1][i]}, 0));
            triangles.push_back(mesh.add_triangle({sites[1][i], next, sites[1][(i + 1) % 4]}, 0));
        }
        for (int i = 0; i < 8; ++i) {
            mesh.link(3 * i + 1, 3 * ((i + 1) % 8) + (i % 2 == 0 ? 0 : 2));
        }
        EXPECT_FALSE(disc_of(mesh, triangles)) << two_sites;
        EXPECT_TRUE(disc_of(mesh, {triangles[0], triangles[1]}));
    }
}

TEST(Cavity, BestApexOfARegularPolygonIsItsMiddle) {
    for (const int corners : {4, 5, 6}) {
        const ClassifiedMesh mesh = polygon(corners, Vec3(0.5, 0.2, 0));
        const auto disc = disc_of(mesh, triangles_around(mesh, 2));
        ASSERT_TRUE(disc);
        const Vec3 apex = best_apex(mesh, *disc);
        const double ideal = fan_angle(mesh, *disc, Vec3::Zero());
        EXPECT_GT(fan_angle(mesh, *disc, apex), ideal - 0.01) << corners;
    }
}

TEST(Cavity, FanFromTheRimLeavesOutTheSidesAtItsApex) {
    const ClassifiedMesh mesh = polygon(6, Vec3(0, 0, 0));
    const auto disc = disc_of(mesh, triangles_around(mesh, 2));
    ASSERT_TRUE(disc);
    EXPECT_EQ(fan(mesh, *disc, mesh.site_of(0)).size(), 4u);
    EXPECT_NEAR(fan_angle(mesh, *disc, mesh.point_of(0), mesh.site_of(0)), M_PI / 6.0, 1e-12);
    EXPECT_LT(fan_angle(mesh, *disc, Vec3(2, 0, 0)), 0.0);  // from outside, some triangles are inverted
}

}  // namespace
}  // namespace mq::triangulate
