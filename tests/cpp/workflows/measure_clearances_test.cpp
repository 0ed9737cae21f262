// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/measure_clearances.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace mq::workflows {
namespace {

/// A tetrahedron with its corner at the origin of its frame, legs along the axes.
triangulate::Result corner_at(const Vec3& origin) {
    triangulate::Result result;
    result.mesh.origin = origin;
    result.mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    result.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    return result;
}

TEST(MeasureClearances, BringsBodiesIntoOneFrame) {
    const triangulate::Result a = corner_at(Vec3(1e6, 0, 0));
    const triangulate::Result b = corner_at(Vec3(1e6 + 3.0, 0, 0));
    Progress progress;
    const auto found = measure_clearances({&a, &b}, {0.0, 0.0}, {}, progress);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].nearest.distance, 2.0, 1e-9);
    EXPECT_NEAR(found[0].nearest.points[0].x(), 1e6 + 1.0, 1e-9);
    EXPECT_NEAR(found[0].nearest.points[1].x(), 1e6 + 3.0, 1e-9);
}

TEST(MeasureClearances, RefusesABodyWithoutTriangles) {
    const triangulate::Result a = corner_at(Vec3(0, 0, 0));
    const triangulate::Result nothing;
    Progress progress;
    EXPECT_THROW(measure_clearances({&a, &nothing}, {0.0, 0.0}, {}, progress), InvalidInput);
}

}  // namespace
}  // namespace mq::workflows
