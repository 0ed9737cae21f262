// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/improve_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mq::workflows {
namespace {

/// A closed cylinder of long triangles: 60 sides, without vertices between its ends.
mesh::TriangleMesh needles() {
    constexpr int kSides = 60;
    mesh::TriangleMesh mesh;
    for (const double z : {0.0, 10.0}) {
        for (int i = 0; i < kSides; ++i) {
            const double angle = 2.0 * M_PI * i / kSides;
            mesh.vertices.push_back(to_single(Vec3(std::cos(angle), std::sin(angle), z)));
        }
    }
    for (int i = 0; i < kSides; ++i) {
        const int j = (i + 1) % kSides;
        mesh.triangles.push_back({i, j, kSides + j});
        mesh.triangles.push_back({i, kSides + j, kSides + i});
        if (i >= 2) {
            mesh.triangles.push_back({0, i, i - 1});
            mesh.triangles.push_back({kSides, kSides + i - 1, kSides + i});
        }
    }
    return mesh;
}

TEST(ImproveSurface, IsMeasuredAndCountsItsOperations) {
    Progress progress;
    improve::ImproveOptions options;
    options.min_angle = 20.0;
    const triangulate::Result result = improve_surface(needles(), options, progress);
    EXPECT_TRUE(result.report.closed);
    EXPECT_EQ(result.report.min_angle_asked, 20.0);
    EXPECT_GE(result.report.min_angle_unexempted, 20.0);
    EXPECT_EQ(result.report.triangles, result.mesh.triangles.size());
    ASSERT_FALSE(result.report.notes.empty());
    EXPECT_EQ(result.report.notes.back().text().rfind("edges swapped: ", 0), 0u);
    EXPECT_FALSE(result.report.seconds.empty());
}

}  // namespace
}  // namespace mq::workflows
