// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/insertion_cavity.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "triangulate/surface_samples.h"

namespace mq::triangulate {
namespace {

/// A flat face of 4 by 4 squares, of two triangles each.
ClassifiedMesh flat_face() {
    samples::SurfaceBuilder builder;
    std::vector<int> vertices;
    for (int j = 0; j <= 4; ++j) {
        for (int i = 0; i <= 4; ++i) {
            vertices.push_back(builder.vertex(Vec3(i, j, 0)));
        }
    }
    builder.grid(0, 4, 4, vertices);
    return builder.mesh;
}

Corner at(double x, double y, double z = 0.0) {
    return {Vec3(x, y, z), Vec3::UnitZ()};
}

TEST(InsertionCavity, OfAPointInsideATriangleIsThatTriangle) {
    const ClassifiedMesh mesh = flat_face();
    const InsertionCavity cavity = grow_cavity(mesh, 0, false, at(0.6, 0.3), kAligned);
    EXPECT_TRUE(cavity.complete);
    EXPECT_EQ(cavity.triangles, std::vector<int>{0});
    EXPECT_EQ(cavity.rim.size(), 3u);
    EXPECT_TRUE(cavity.outside.empty());
}

TEST(InsertionCavity, GrowsAcrossSidesThatWouldFold) {
    const ClassifiedMesh mesh = flat_face();
    // Triangle 0 is the lower one of the first square; the point lies in the square above.
    const InsertionCavity cavity = grow_cavity(mesh, 0, false, at(0.4, 0.8), kAligned);
    ASSERT_TRUE(cavity.complete);
    EXPECT_EQ(cavity.triangles.size(), 2u);
    EXPECT_EQ(cavity.rim.size(), 4u);
    EXPECT_EQ(cavity.outside.size(), 1u);
    for (const int side : cavity.rim) {
        const double a = alignment(corner_of(mesh, mesh.site_of(side)),
                                   corner_of(mesh, mesh.site_of(ClassifiedMesh::next(side))), at(0.4, 0.8));
        EXPECT_GE(a, kAligned);
    }
}

TEST(InsertionCavity, EndsAtTheSegmentThatIsInTheWay) {
    const ClassifiedMesh mesh = flat_face();
    const InsertionCavity cavity = grow_cavity(mesh, 0, false, at(0.5, -0.5), kAligned);
    EXPECT_FALSE(cavity.complete);
    EXPECT_GE(cavity.segment, 0);
    EXPECT_EQ(mesh.segment_of(0), cavity.segment) << "the side on the border";
}

TEST(InsertionCavity, TheSegmentThatIsSplitIsNoSideOfIt) {
    const ClassifiedMesh mesh = flat_face();
    const InsertionCavity cavity = grow_cavity(mesh, 0, true, at(0.5, 0.0), kAligned);
    EXPECT_TRUE(cavity.complete);
    EXPECT_EQ(cavity.rim.size(), 2u);
    EXPECT_EQ(std::count(cavity.rim.begin(), cavity.rim.end(), 0), 0);
}

}  // namespace
}  // namespace mq::triangulate
