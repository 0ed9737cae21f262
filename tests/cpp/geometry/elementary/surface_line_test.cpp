// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/elementary/surface_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace mq::geometry {
namespace {

using Kind = ElementarySurface::Kind;

ElementarySurface surface_of(Kind kind, const Vec3& origin = Vec3::Zero()) {
    ElementarySurface surface;
    surface.kind = kind;
    surface.origin = origin;
    surface.radius = kind == Kind::Torus ? 3.0 : 2.0;
    surface.minor = 1.0;
    surface.angle = 0.4;
    return surface;
}

const std::vector<Kind> kAll{Kind::Plane, Kind::Cylinder, Kind::Cone, Kind::Sphere, Kind::Torus};

/// The line through two points of a surface has both among its roots, and the normal there is across the surface.
TEST(SurfaceLine, PassesThroughThePointsThatItWasDrawnThrough) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(0.0, 6.0), v(-1.0, 1.0), far(-1e3, 1e3);
    for (int round = 0; round < 4000; ++round) {
        ElementarySurface s = surface_of(kAll[static_cast<std::size_t>(round % 5)]);
        s.origin = Vec3(far(random), far(random), far(random));
        s.x = Vec3(far(random), far(random), far(random)).normalized();
        s.y = s.x.unitOrthogonal();
        s.z = s.x.cross(s.y) * (round % 2 == 0 ? 1.0 : -1.0);
        const SurfacePoint a = s.at(u(random), v(random));
        const bool flat = s.kind == Kind::Plane;
        const Vec3 b = flat ? a.point + s.z + s.x : s.at(u(random), v(random)).point;
        if ((a.point - b).norm() < 0.1) {
            continue;
        }
        const Vec3 direction = (b - a.point).normalized();
        const LineRoots roots = line_roots(s, a.point - 10.0 * direction, direction);
        double off = 1e300;
        for (int i = 0; i < roots.count; ++i) {
            off = std::min(off, std::abs(roots.t[static_cast<std::size_t>(i)] - 10.0));
            EXPECT_TRUE(i == 0 || roots.t[static_cast<std::size_t>(i - 1)] <= roots.t[static_cast<std::size_t>(i)]);
        }
        // A line that nearly touches is the less accurate, the flatter it meets the surface.
        const Vec3 normal = a.su.cross(a.sv).normalized();
        ASSERT_LT(off * std::abs(normal.dot(direction)), 1e-9) << static_cast<int>(s.kind) << " " << round;
        EXPECT_LT(normal_near(s, a.point).cross(normal).norm(), 1e-9);
        EXPECT_NEAR(normal_near(s, a.point).norm(), 1.0, 1e-12);
    }
}

TEST(SurfaceLine, KnownDepths) {
    const LineRoots ball = line_roots(surface_of(Kind::Sphere), Vec3(-5, 1.2, 0), Vec3::UnitX());
    ASSERT_EQ(ball.count, 2);
    EXPECT_NEAR(ball.t[0], 5.0 - 1.6, 1e-14);
    EXPECT_NEAR(ball.t[1], 5.0 + 1.6, 1e-14);
    const LineRoots tube = line_roots(surface_of(Kind::Torus), Vec3(-7, 0, 0), Vec3::UnitX());
    ASSERT_EQ(tube.count, 4);
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(tube.t[static_cast<std::size_t>(i)], (std::array<double, 4>{3.0, 5.0, 9.0, 11.0})[i], 1e-13);
    }
    const LineRoots through_the_hole = line_roots(surface_of(Kind::Torus), Vec3(0.1, 0.2, -9), Vec3::UnitZ());
    EXPECT_EQ(through_the_hole.count, 0);
    ElementarySurface cone = surface_of(Kind::Cone);
    cone.angle = -std::atan(0.5);  // the apex is at z = 4
    const LineRoots side = line_roots(cone, Vec3(-9, 0, 2), Vec3::UnitX());
    ASSERT_EQ(side.count, 2);
    EXPECT_NEAR(side.t[0], 8.0, 1e-14);
    EXPECT_NEAR(side.t[1], 10.0, 1e-14);
    const LineRoots apex = line_roots(cone, Vec3(0, 0, -9), Vec3::UnitZ());
    ASSERT_EQ(apex.count, 2);
    EXPECT_NEAR(apex.t[0], 13.0, 1e-7);
    EXPECT_NEAR(apex.t[1], 13.0, 1e-7);
    EXPECT_EQ(normal_near(cone, Vec3(0, 0, 4)), Vec3(0, 0, 0));
    const LineRoots generator = line_roots(cone, Vec3(2, 0, 0), Vec3(-1, 0, 2).normalized());
    EXPECT_LE(generator.count, 2);
}

TEST(SurfaceLine, LinesBesideOrAlongTheSurfaceDoNotMeetIt) {
    for (const Kind kind : {Kind::Sphere, Kind::Torus, Kind::Cylinder}) {
        EXPECT_EQ(line_roots(surface_of(kind), Vec3(-9, 4.1, 0), Vec3::UnitX()).count, 0);
    }
    EXPECT_EQ(line_roots(surface_of(Kind::Cylinder), Vec3(0, 0, 0), Vec3::UnitZ()).count, 0);
    EXPECT_EQ(line_roots(surface_of(Kind::Plane), Vec3(0, 0, 1), Vec3::UnitX()).count, 0);
}

}  // namespace
}  // namespace mq::geometry
