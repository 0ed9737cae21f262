// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/distance_bound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boolean/closed_solids.h"

namespace mq::offset {
namespace {

const Progress kUnwatched;

TEST(DistanceBound, AFlatTriangleAboveAFaceIsAtItsDistance) {
    const mesh::TriangleMesh box = boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    const std::vector<Corners> above{{Vec3(1, 1, 12), Vec3(9, 1, 12), Vec3(1, 9, 12)}};
    EXPECT_NEAR(deviation_from_distance(above, surface, 2.0, 1e-5, kUnwatched).bound, 0.0, 1e-4);
    EXPECT_NEAR(deviation_from_distance(above, surface, 1.5, 1e-5, kUnwatched).bound, 0.5, 1e-4);
    EXPECT_NEAR(deviation_from_distance(above, surface, 2.75, 1e-5, kUnwatched).bound, 0.75, 1e-4);
}

TEST(DistanceBound, ANearMissAmidATriangleIsFound) {
    // The corners are far from the box; the triangle's inside passes a corner of it at 0.5.
    const mesh::TriangleMesh box = boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    const std::vector<Corners> triangle{{Vec3(-30, -30, 10.5), Vec3(60, -30, 10.5), Vec3(5, 70, 10.5)}};
    const ProvenBound bound = deviation_from_distance(triangle, surface, 40.0, 1e-3, kUnwatched);
    EXPECT_GE(bound.bound, 39.5 - 1e-9);
}

TEST(DistanceBound, ATriangleThatCrossesTheSurfaceIsAtNoDistance) {
    // Its corners and edges are far from the edges and corners of the face that it goes through.
    const mesh::TriangleMesh box = boolean::solids::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const SearchedSurface surface(box.vertices, box.triangles);
    const std::vector<Corners> through{{Vec3(6, 2, 8), Vec3(6.5, 2, 13), Vec3(7, 3, 13)}};
    EXPECT_NEAR(deviation_from_distance(through, surface, 2.0, 1e-3, kUnwatched).bound, 2.0, 1e-9);
}

}  // namespace
}  // namespace mq::offset
