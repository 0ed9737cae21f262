// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/elementary/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace mq::geometry {
namespace {

using Kind = ElementarySurface::Kind;

ElementarySurface surface_of(Kind kind) {
    ElementarySurface surface;
    surface.kind = kind;
    surface.origin = Vec3(1.0, -2.0, 0.5);
    surface.x = Vec3(1.0, 1.0, 0.0).normalized();
    surface.y = Vec3(-1.0, 1.0, 0.0).normalized();
    surface.radius = kind == Kind::Torus ? 3.0 : 2.0;
    surface.minor = 1.0;
    surface.angle = 0.4;
    return surface;
}

const std::vector<Kind> kAll{Kind::Plane, Kind::Cylinder, Kind::Cone, Kind::Sphere, Kind::Torus};

TEST(ElementarySurface, DerivativesAreThoseOfItsPoints) {
    constexpr double kStep = 1e-5;
    for (const Kind kind : kAll) {
        const ElementarySurface s = surface_of(kind);
        for (const double u : {0.3, 2.0, 5.5}) {
            for (const double v : {-0.7, 0.2, 1.1}) {
                const SurfacePoint here = s.at(u, v);
                const SurfacePoint du = s.at(u + kStep, v);
                const SurfacePoint du_back = s.at(u - kStep, v);
                const SurfacePoint dv = s.at(u, v + kStep);
                const SurfacePoint dv_back = s.at(u, v - kStep);
                const double scale = 0.5 / kStep;
                EXPECT_LT((scale * (du.point - du_back.point) - here.su).norm(), 1e-8);
                EXPECT_LT((scale * (dv.point - dv_back.point) - here.sv).norm(), 1e-8);
                EXPECT_LT((scale * (du.su - du_back.su) - here.suu).norm(), 1e-8);
                EXPECT_LT((scale * (dv.su - dv_back.su) - here.suv).norm(), 1e-8);
                EXPECT_LT((scale * (dv.sv - dv_back.sv) - here.svv).norm(), 1e-8);
            }
        }
    }
}

TEST(ElementarySurface, APointAboveItIsNearestToWhereItStands) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> turn(0.1, 6.1), latitude(-1.2, 1.2), height(-0.4, 0.4);
    const ParameterBox box{{0.0, -1.5}, {2.0 * M_PI, 1.5}};
    for (const Kind kind : kAll) {
        const ElementarySurface s = surface_of(kind);
        for (int i = 0; i < 200; ++i) {
            const Vec2 uv(turn(random), latitude(random));
            const SurfacePoint at = s.at(uv.x(), uv.y());
            const std::optional<SurfaceProjection> found =
                s.nearest(at.point + height(random) * at.su.cross(at.sv).normalized(), box, uv);
            ASSERT_TRUE(found);
            EXPECT_LT((found->uv - uv).norm(), 1e-9) << static_cast<int>(kind);
            EXPECT_LT((found->at.point - at.point).norm(), 1e-12);
            EXPECT_LT((found->at.su - at.su).norm(), 1e-12);
            EXPECT_LT((found->at.sv - at.sv).norm(), 1e-12);
        }
    }
}

TEST(ElementarySurface, AnswersLieWithinTheBox) {
    const ElementarySurface cylinder = surface_of(Kind::Cylinder);
    const ParameterBox box{{0.0, 0.0}, {1.0, 2.0}};
    const std::optional<SurfaceProjection> above = cylinder.nearest(cylinder.at(0.5, 7.0).point, box, Vec2(0.5, 1.0));
    ASSERT_TRUE(above);
    EXPECT_LT((above->uv - Vec2(0.5, 2.0)).norm(), 1e-12);
    const std::optional<SurfaceProjection> aside = cylinder.nearest(cylinder.at(1.3, 1.0).point, box, Vec2(0.5, 1.0));
    ASSERT_TRUE(aside);
    EXPECT_LT((aside->uv - Vec2(1.0, 1.0)).norm(), 1e-12);
    EXPECT_LT((aside->at.point - cylinder.at(1.0, 1.0).point).norm(), 1e-12);
}

TEST(ElementarySurface, WhereAllPointsAreEquallyNearTheGuessDecidesOrNothing) {
    const ParameterBox box{{0.0, -1.5}, {2.0 * M_PI, 1.5}};
    const ElementarySurface cylinder = surface_of(Kind::Cylinder);
    const std::optional<SurfaceProjection> on_axis =
        cylinder.nearest(cylinder.origin + 0.5 * cylinder.z, box, Vec2(2.5, 0.0));
    ASSERT_TRUE(on_axis);
    EXPECT_DOUBLE_EQ(on_axis->uv.x(), 2.5);
    const ElementarySurface sphere = surface_of(Kind::Sphere);
    EXPECT_FALSE(sphere.nearest(sphere.origin, box, Vec2(1.0, 0.0)));
}

TEST(BranchNearest, DiffersByHalfAPeriodAtMost) {
    for (const double angle : {-20.0, -3.0, 0.0, 1.0, 50.0}) {
        for (const double near : {-7.0, 0.0, 4.0}) {
            const double found = branch_nearest(angle, near, 2.0 * M_PI);
            EXPECT_LE(std::abs(found - near), M_PI * (1.0 + 1e-12));
            const double turns = (found - angle) / (2.0 * M_PI);
            EXPECT_NEAR(turns, std::round(turns), 1e-12);
        }
    }
}

}  // namespace
}  // namespace mq::geometry
