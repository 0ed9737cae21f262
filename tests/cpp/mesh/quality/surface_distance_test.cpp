// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/surface_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"

namespace mq::mesh {
namespace {

TriangleMesh square(double side, double height) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, height}, {side, 0, height}, {side, side, height}, {0, side, height}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

TEST(SurfaceDistance, OfParallelSquaresIsTheirHeight) {
    const SurfaceDistance distance = surface_distance(square(1.0, 0.0), square(1.0, 0.25), Progress());
    EXPECT_DOUBLE_EQ(distance.mean, 0.25);
    EXPECT_DOUBLE_EQ(distance.largest, 0.25);
}

TEST(SurfaceDistance, HasADirection) {
    const TriangleMesh small = square(1.0, 0.0), large = square(4.0, 0.0);
    EXPECT_NEAR(surface_distance(small, large, Progress()).largest, 0.0, 1e-15);
    const SurfaceDistance back = surface_distance(large, small, Progress());
    EXPECT_DOUBLE_EQ(back.largest, std::sqrt(18.0));
    EXPECT_TRUE(back.where.isApprox(Vec3(4, 4, 0)));
    EXPECT_GT(back.mean, 0.0);
    EXPECT_LT(back.mean, back.largest);
}

TEST(SurfaceDistance, OfNothingFromSomethingIsAnError) {
    EXPECT_THROW(surface_distance(square(1.0, 0.0), TriangleMesh(), Progress()), InvalidInput);
    EXPECT_EQ(surface_distance(TriangleMesh(), TriangleMesh(), Progress()).largest, 0.0);
}

}  // namespace
}  // namespace mq::mesh
