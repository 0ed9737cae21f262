// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/contoured/distance_level_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boolean/closed_solids.h"

namespace mq::offset {
namespace {

OffsetSurface surface_of(const mesh::TriangleMesh& mesh) {
    return {mesh.vertices, mesh.triangles, std::vector<std::int32_t>(mesh.triangles.size(), 0), true};
}

TEST(DistanceLevelSet, IsTheSignedDistanceLessTheOneAskedFor) {
    const OffsetSurface box = surface_of(boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10)));
    const DistanceLevelSet level_set(box, 1.0, 1e-6);
    EXPECT_NEAR(level_set.at(Vec3(5, 5, 13), -1).value, 2.0, 1e-12);
    EXPECT_NEAR(level_set.at(Vec3(5, 5, 9), -1).value, -2.0, 1e-12);
    // Nearest are an edge and a vertex there.
    EXPECT_NEAR(level_set.at(Vec3(5, 13, 14), -1).value, 4.0, 1e-12);
    EXPECT_NEAR(level_set.at(Vec3(-2, -3, -6), 7).value, 6.0, 1e-12);
    EXPECT_NEAR((level_set.at(Vec3(-2, -3, -6), -1).gradient - Vec3(-2, -3, -6) / 7.0).norm(), 0.0, 1e-12);
    EXPECT_NEAR((level_set.at(Vec3(5, 5, 9), -1).gradient - Vec3(0, 0, 1)).norm(), 0.0, 1e-12);
}

TEST(DistanceLevelSet, KnowsSidesBesideEdgesOfSharpAndReflexAngles) {
    // A thin wedge: at points near its edge the nearest face alone would often name the wrong side.
    mesh::TriangleMesh wedge = boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    for (Vec3& p : wedge.vertices) {
        p.z() *= 1e-5 + 0.01 * p.x();
    }
    const OffsetSurface surface = surface_of(wedge);
    const DistanceLevelSet level_set(surface, 0.0, 1e-6);
    for (int k = 0; k < 200; ++k) {
        const double angle = 2.0 * M_PI * k / 200.0;
        const Vec3 before(-1.0 + 0.9 * std::cos(angle), 5.0, 0.9 * std::sin(angle));
        EXPECT_GT(level_set.at(before, -1).value, 0.0) << before.transpose();
    }
    EXPECT_LT(level_set.at(Vec3(9, 5, 0.5), -1).value, 0.0);
}

TEST(DistanceLevelSet, OfAnEdgeTheLowestPatchDecides) {
    OffsetSurface box = surface_of(boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10)));
    for (std::size_t t = 0; t < box.triangles.size(); ++t) {
        box.patch[t] = static_cast<std::int32_t>(t / 2);
    }
    const DistanceLevelSet level_set(box, 1.0, 1e-6);
    const std::int32_t patch = level_set.patch(level_set.at(Vec3(5, 10.6, 10.6), -1).source);
    for (int k = 1; k < 50; ++k) {
        const double angle = M_PI / 2 * k / 50.0;
        const Vec3 round(0.2 * k, 10.0 + std::cos(angle), 10.0 + std::sin(angle));
        EXPECT_EQ(level_set.patch(level_set.at(round, -1).source), patch);
    }
}

TEST(DistanceLevelSet, BothSidesOfASheetCount) {
    OffsetSurface sheet{{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0)}, {{0, 1, 2}}, {0}, false};
    const DistanceLevelSet level_set(sheet, 1.0, 1e-6);
    EXPECT_NEAR(level_set.at(Vec3(2, 2, 3), -1).value, 2.0, 1e-12);
    EXPECT_NEAR(level_set.at(Vec3(2, 2, -3), -1).value, 2.0, 1e-12);
}

}  // namespace
}  // namespace mq::offset
