// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/reference_surface.h"

#include <gtest/gtest.h>

#include "base/angle.h"
#include "improve/flat_grid.h"

namespace mq::improve {
namespace {

TEST(ReferenceSurface, DistancesAreThoseOfTheGivenMeshAndOfItsSharpEdges) {
    const mesh::TriangleMesh given = flat_grid(4);
    const EditableMesh editable(given, 35.0 * kDegree);
    const ReferenceSurface reference(given, editable);
    const Vec3 above(1.3, 2.2, 0.25);
    EXPECT_TRUE(reference.within(above, 0.25));
    EXPECT_FALSE(reference.within(above, 0.2499));
    EXPECT_EQ(reference.project(above), in_single(Vec3(1.3, 2.2, 0.0)));
    const ReferenceSurface::SurfaceProjection projection = reference.foot(above);
    EXPECT_DOUBLE_EQ(projection.distance, 0.25);
    EXPECT_EQ(projection.normal, Vec3::UnitZ());
    // The border is all that is sharp on a flat mesh.
    EXPECT_FALSE(reference.sharp_edges_within(above, 1.3));
    EXPECT_TRUE(reference.sharp_edges_within(above, 1.33));
    EXPECT_EQ(reference.project_to_sharp_edges(above), in_single(Vec3(0.0, 2.2, 0.0)));
}

TEST(ReferenceSurface, EarlierQueriesDoNotChangeTheAnswers) {
    const mesh::TriangleMesh given = flat_grid(8);
    const EditableMesh editable(given, 35.0 * kDegree);
    const ReferenceSurface used(given, editable);
    for (int i = 0; i < 50; ++i) {
        const Vec3 p(0.17 * i, 8.0 - 0.13 * i, 0.01 * i);
        const ReferenceSurface fresh(given, editable);
        EXPECT_EQ(used.project(p), fresh.project(p));
        EXPECT_EQ(used.project_to_sharp_edges(p), fresh.project_to_sharp_edges(p));
        EXPECT_EQ(used.foot(p).distance, fresh.foot(p).distance);
    }
}

TEST(ReferenceSurface, SinglePrecisionIsTheNearest) {
    const Vec3 p(0.1, 1e10 + 0.3, -1.0 / 3.0);
    EXPECT_TRUE(is_single(in_single(p)));
    EXPECT_EQ(in_single(p), to_single(p));
}

}  // namespace
}  // namespace mq::improve
