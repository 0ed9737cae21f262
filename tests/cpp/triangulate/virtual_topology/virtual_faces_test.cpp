// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/virtual_topology/virtual_faces.h"

#include <algorithm>

#include "triangulate/checks.h"
#include "triangulate/virtual_topology/smooth_edges.h"
#include "triangulate/virtual_topology/stadium.h"

namespace mq::triangulate {
namespace {

constexpr double kFeatureAngle = 10.0;  // degrees

/// A refined stadium, whose half circles and straight sides meet in four smooth edges.
struct Stadium : Pipeline {
    Stadium() : Pipeline(stadium(1)) {
        refine(20.0);
        smooth = smooth_edges(work, kFeatureAngle, {});
    }

    std::set<int> vertices_on_smooth_edges() const {
        std::set<int> result;
        for (int s = 0; s < surface.segment_count(); ++s) {
            const ClassifiedMesh::Segment& segment = surface.segment(s);
            if (smooth[static_cast<std::size_t>(segment.edge)] != 0) {
                result.insert(segment.vertices.begin(), segment.vertices.end());
            }
        }
        return result;
    }

    std::vector<char> smooth;
};

TEST(VirtualFaces, DissolveTheSegmentsOfSmoothEdgesAlone) {
    Stadium part;
    const std::set<int> expected = part.vertices_on_smooth_edges();
    ASSERT_GE(expected.size(), 8u);
    const VirtualFaces faces(part.surface, part.smooth, kFeatureAngle);
    const std::vector<int> found = faces.vertices_on_edges();
    EXPECT_EQ(std::set<int>(found.begin(), found.end()), expected);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (const int v : found) {
        // At the corners the lids meet the sides, and normals are a right angle apart; along the edges they are the
        // same.
        EXPECT_EQ(faces.locked(v), part.surface.vertex(v).entity[0] == 0);
    }
    for (int h = 0; h < part.surface.half_edge_count(); ++h) {
        const int segment = part.surface.segment_of(h);
        if (segment >= 0) {
            EXPECT_EQ(part.smooth[static_cast<std::size_t>(part.surface.segment(segment).edge)], 0);
        }
    }
}

TEST(VirtualFaces, InsideAPatchAVertexHasOneUse) {
    Stadium part;
    const VirtualFaces faces(part.surface, part.smooth, kFeatureAngle);
    for (int h = 0; h < part.surface.half_edge_count(); ++h) {
        for (const int spoke : part.surface.star(h)) {
            EXPECT_EQ(part.surface.site_of(spoke), part.surface.site_of(h));
        }
    }
}

TEST(VirtualFaces, WithoutChangesTheUsesOfTheFacesComeBack) {
    Stadium part;
    std::vector<int> before;
    for (int h = 0; h < part.surface.half_edge_count(); ++h) {
        before.push_back(part.surface.site_of(h));
    }
    VirtualFaces faces(part.surface, part.smooth, kFeatureAngle);
    EXPECT_TRUE(faces.settle(part.work).empty());
    for (int h = 0; h < part.surface.half_edge_count(); ++h) {
        EXPECT_EQ(part.surface.site_of(h), before[static_cast<std::size_t>(h)]);
    }
}

TEST(VirtualFaces, CadSamplesOfATriangleLieOnItsFaceAndGoToTheNearestNewOne) {
    Stadium part;
    VirtualFaces faces(part.surface, part.smooth, kFeatureAngle);
    const std::vector<CadSample> samples = faces.passengers(part.work, {0, 1});
    ASSERT_EQ(samples.size(), 8u) << "the centroid and the middles of the sides of each";
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const int triangle = i < 4 ? 0 : 1;
        EXPECT_EQ(samples[i].face, part.surface.face_of(triangle));
        const auto on_face =
            part.session.ask(geometry::Query::face_point(samples[i].face, samples[i].uv.x(), samples[i].uv.y()));
        EXPECT_LT((part.grid.to_shape(samples[i].point) - on_face.point).norm(), 1e-6);
    }
    EXPECT_FALSE(faces.changed(0));
    faces.replaced({0, 1}, samples);
    EXPECT_TRUE(faces.changed(0));
    EXPECT_TRUE(faces.changed(1));
    // None is lost, whichever of the two it went to.
    EXPECT_EQ(faces.passengers(part.work, {0, 1}).size(), samples.size());
}

TEST(VirtualFaces, TrianglesAcrossASmoothEdgeAreNamedWithBothFaces) {
    Stadium part;
    // A triangle that has a corner on a smooth edge, before that is dissolved.
    const std::set<int> on_edges = part.vertices_on_smooth_edges();
    int triangle = -1;
    for (int t = 0; t < part.surface.triangle_count() && triangle < 0; ++t) {
        triangle = on_edges.count(part.surface.vertex_of(3 * t)) > 0 ? t : -1;
    }
    ASSERT_GE(triangle, 0);
    VirtualFaces faces(part.surface, part.smooth, kFeatureAngle);
    faces.replaced({triangle}, faces.passengers(part.work, {triangle}));
    const std::map<int, MultiFaceClassification> spans = faces.settle(part.work);
    for (const auto& [t, span] : spans) {
        EXPECT_EQ(t, triangle);
        EXPECT_EQ(span.faces.front(), part.surface.face_of(t)) << "the face with the largest share first";
    }
    EXPECT_EQ(part.surface.inconsistency(), "");
}

}  // namespace
}  // namespace mq::triangulate
