// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/components/mesh_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "triangulate/ring_mesh.h"

namespace mq::triangulate {
namespace {

/// Adds a polygon with its corners joined to a point inside, on a face of its own, at a distance from the others.
void add_ring(ClassifiedMesh& mesh, int corners, int face) {
    std::vector<Vec3> around;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * 3.14159 * i / corners;
        around.emplace_back(10.0 * face + std::cos(angle), std::sin(angle), 0.0);
    }
    const ClassifiedMesh ring = ring_mesh(around, Vec3(10.0 * face, 0, 0));
    const int vertices = mesh.vertex_count();
    const int sites = mesh.site_count();
    const int segments = mesh.segment_count();
    const int first = mesh.half_edge_count();
    for (int v = 0; v < ring.vertex_count(); ++v) {
        mesh.add_vertex(ring.vertex(v).point, ring.vertex(v).entity);
    }
    for (int s = 0; s < ring.site_count(); ++s) {
        ClassifiedMesh::VertexUse site = ring.site(s);
        site.vertex += vertices;
        mesh.add_site(site);
    }
    for (int t = 0; t < ring.triangle_count(); ++t) {
        mesh.add_triangle(
            {ring.site_of(3 * t) + sites, ring.site_of(3 * t + 1) + sites, ring.site_of(3 * t + 2) + sites}, face);
    }
    for (int s = 0; s < ring.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = ring.segment(s);
        mesh.add_segment(segment.edge, {segment.vertices[0] + vertices, segment.vertices[1] + vertices}, segment.t);
        for (const ClassifiedMesh::SegmentUse& use : segment.uses) {
            mesh.bind(use.half_edge + first, segments + s, use.use);
        }
    }
    for (int h = 0; h < ring.half_edge_count(); ++h) {
        if (h < ring.twin(h)) {
            mesh.link(first + h, first + ring.twin(h));
        }
    }
}

ClassifiedMesh rings(const std::vector<int>& corners) {
    ClassifiedMesh mesh;
    for (std::size_t face = 0; face < corners.size(); ++face) {
        add_ring(mesh, corners[face], static_cast<int>(face));
    }
    EXPECT_EQ(mesh.inconsistency(), "");
    return mesh;
}

/// Bodies of one face each.
std::vector<int> apart(int faces) {
    std::vector<int> bodies(static_cast<std::size_t>(faces));
    std::iota(bodies.begin(), bodies.end(), 0);
    return bodies;
}

std::vector<MeshComponent> divide(const ClassifiedMesh& mesh, const std::vector<int>& together,
                                  const std::vector<double>& work, std::size_t most) {
    const std::vector<MeshBody> bodies = bodies_of(mesh, together, work);
    std::vector<double> of_bodies;
    for (const MeshBody& body : bodies) {
        of_bodies.push_back(body.work);
    }
    std::vector<MeshComponent> components;
    for (const std::vector<int>& group : groups_of(of_bodies, most)) {
        std::vector<int> triangles;
        for (const int b : group) {
            const std::vector<int>& of_body = bodies[static_cast<std::size_t>(b)].triangles;
            triangles.insert(triangles.end(), of_body.begin(), of_body.end());
        }
        std::sort(triangles.begin(), triangles.end());
        components.push_back(component_of(mesh, std::move(triangles)));
    }
    return components;
}

/// The same work is expected on all triangles.
std::vector<MeshComponent> divide_evenly(const ClassifiedMesh& mesh, const std::vector<int>& together,
                                         std::size_t most) {
    return divide(mesh, together, std::vector<double>(static_cast<std::size_t>(mesh.triangle_count()), 2.0), most);
}

std::vector<const MeshComponent*> all(const std::vector<MeshComponent>& components) {
    std::vector<const MeshComponent*> result;
    for (const MeshComponent& component : components) {
        result.push_back(&component);
    }
    return result;
}

std::vector<std::size_t> sizes(const std::vector<MeshComponent>& components) {
    std::vector<std::size_t> result;
    for (const MeshComponent& component : components) {
        result.push_back(component.triangles.size());
    }
    return result;
}

TEST(MeshComponents, TheLargestComponentIsTheFirst) {
    const std::vector<MeshComponent> found = divide_evenly(rings({3, 5, 4, 5}), apart(4), 10);
    EXPECT_EQ(sizes(found), (std::vector<std::size_t>{5, 5, 4, 3}));
    EXPECT_EQ(found[0].mesh.face_of(0), 1);
    EXPECT_EQ(found[1].mesh.face_of(0), 3);
    for (const MeshComponent& component : found) {
        EXPECT_EQ(component.mesh.inconsistency(), "");
        EXPECT_TRUE(std::is_sorted(component.triangles.begin(), component.triangles.end()));
        EXPECT_EQ(component.vertices.size(), component.triangles.size() + 1);
        EXPECT_EQ(component.segments.size(), component.triangles.size());
    }
}

TEST(MeshComponents, SmallOnesAreTogetherWhereThereAreMany) {
    const std::vector<MeshComponent> found = divide_evenly(rings({3, 8, 4, 5, 3, 3}), apart(6), 3);
    EXPECT_EQ(sizes(found), (std::vector<std::size_t>{10, 8, 8}));
    for (const MeshComponent& component : found) {
        EXPECT_EQ(component.mesh.inconsistency(), "");
    }
}

TEST(MeshComponents, FacesOfABodyAreTogether) {
    const std::vector<MeshComponent> found = divide_evenly(rings({3, 5, 4, 5}), {0, 1, 0, 2}, 10);
    EXPECT_EQ(sizes(found), (std::vector<std::size_t>{7, 5, 5}));
    EXPECT_EQ(found[0].mesh.inconsistency(), "");
    EXPECT_EQ(found[0].mesh.face_of(0), 0);
    EXPECT_EQ(found[0].mesh.face_of(6), 2);
}

TEST(MeshComponents, TheOneWithMostWorkIsTheFirst) {
    std::vector<double> work(7, 1.0);
    work[5] = 4.0;
    EXPECT_EQ(sizes(divide(rings({4, 3}), apart(2), work, 10)), (std::vector<std::size_t>{3, 4}));
}

TEST(MeshComponents, AnEmptyMeshHasNone) {
    EXPECT_TRUE(bodies_of(ClassifiedMesh(), {}, {}).empty());
    EXPECT_TRUE(groups_of({}, 10).empty());
}

TEST(MeshComponents, TheWorkOfABodyIsThatOfItsTriangles) {
    std::vector<double> work(7, 1.0);
    work[5] = 4.0;
    const std::vector<MeshBody> bodies = bodies_of(rings({4, 3}), apart(2), work);
    ASSERT_EQ(bodies.size(), 2U);
    EXPECT_EQ(bodies[0].work, 6.0);
    EXPECT_EQ(bodies[0].triangles, (std::vector<int>{4, 5, 6}));
    EXPECT_EQ(bodies[1].work, 4.0);
}

TEST(MeshComponents, GroupsAreFilledFromTheSmallest) {
    EXPECT_EQ(groups_of({5.0, 3.0, 2.0, 2.0}, 4), (std::vector<std::vector<int>>{{0}, {1}, {2}, {3}}));
    EXPECT_EQ(groups_of({5.0, 3.0, 2.0, 2.0}, 2), (std::vector<std::vector<int>>{{0, 2}, {1, 3}}));
}

/// Nothing uses what was there of a body whose mesh another one has taken the place of.
TEST(MeshComponents, AnotherMeshMayTakeThePlaceOfABody) {
    const ClassifiedMesh mesh = rings({3, 5});
    std::vector<MeshComponent> found = divide_evenly(mesh, apart(2), 10);
    ASSERT_EQ(found[1].triangles.size(), 3U);
    const int kept = found[1].vertices[1];
    const std::vector<int> sites = found[1].sites;
    found[1].vertices = {-1, kept, -1, -1};
    found[1].sites = {};
    found[1].segments = {};
    const JoinedComponents joined = join(mesh, all(found));
    EXPECT_EQ(joined.mesh.inconsistency(), "");
    EXPECT_EQ(joined.mesh.triangle_count(), mesh.triangle_count());
    EXPECT_EQ(joined.vertices[1], (std::vector<int>{10, kept, 11, 12}));
    EXPECT_EQ(joined.mesh.vertex_count(), mesh.vertex_count() + 3);
    EXPECT_EQ(joined.mesh.segment_count(), mesh.segment_count());
    for (int t = joined.first[1]; t < joined.first[1] + 3; ++t) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            EXPECT_EQ(std::count(sites.begin(), sites.end(), joined.mesh.site_of(h)), 0);
        }
    }
    for (int s = 0; s < joined.mesh.segment_count(); ++s) {
        EXPECT_FALSE(joined.mesh.segment(s).uses.empty());
    }
}

TEST(MeshComponents, JoinedUnchangedTheyAreTheMesh) {
    const ClassifiedMesh mesh = rings({3, 5, 4});
    const std::vector<MeshComponent> found = divide_evenly(mesh, apart(3), 10);
    const JoinedComponents joined = join(mesh, all(found));
    EXPECT_EQ(joined.mesh.inconsistency(), "");
    EXPECT_EQ(joined.first, (std::vector<int>{0, 5, 9}));
    ASSERT_EQ(joined.mesh.triangle_count(), mesh.triangle_count());
    ASSERT_EQ(joined.mesh.vertex_count(), mesh.vertex_count());
    for (std::size_t c = 0; c < found.size(); ++c) {
        EXPECT_EQ(joined.vertices[c], found[c].vertices);
        for (std::size_t i = 0; i < found[c].triangles.size(); ++i) {
            for (int k = 0; k < 3; ++k) {
                const int here = 3 * (joined.first[c] + static_cast<int>(i)) + k;
                const int before = 3 * found[c].triangles[i] + k;
                EXPECT_EQ(joined.mesh.site_of(here), mesh.site_of(before));
                EXPECT_EQ(joined.mesh.segment_of(here), mesh.segment_of(before));
                EXPECT_EQ(joined.mesh.point_of(here), mesh.point_of(before));
            }
        }
    }
}

TEST(MeshComponents, ChangesOfSeveralAreJoined) {
    const ClassifiedMesh mesh = rings({3, 5});
    std::vector<MeshComponent> found = divide_evenly(mesh, apart(2), 10);
    for (MeshComponent& component : found) {
        ClassifiedMesh& own = component.mesh;
        const int inside =
            own.add_vertex((own.point_of(0) + own.point_of(1) + own.point_of(2)) / 3.0, {2, own.face_of(0)});
        own.split_triangle(0, own.add_site({inside, Vec2(0.1, 0.1), Vec3(0, 0, 1)}));
        const ClassifiedMesh::Segment segment = own.segment(1);
        const int middle = own.add_vertex(
            0.5 * (own.vertex(segment.vertices[0]).point + own.vertex(segment.vertices[1]).point), {1, segment.edge});
        own.split_segment(1, middle, 0.5, {own.add_site({middle, Vec2(0.2, 0.2), Vec3(0, 0, 1)})});
    }
    const JoinedComponents joined = join(mesh, all(found));
    EXPECT_EQ(joined.mesh.inconsistency(), "");
    EXPECT_EQ(joined.mesh.vertex_count(), mesh.vertex_count() + 4);
    EXPECT_EQ(joined.mesh.triangle_count(), mesh.triangle_count() + 6);
    ASSERT_EQ(joined.mesh.segment_count(), mesh.segment_count() + 2);
    for (std::size_t c = 0; c < found.size(); ++c) {
        const int kept = found[c].segments[1];
        const int added = mesh.segment_count() + static_cast<int>(c);
        EXPECT_EQ(joined.mesh.segment(kept).vertices[1], joined.mesh.segment(added).vertices[0]);
        EXPECT_EQ(joined.mesh.segment(kept).t[1], 0.5);
        EXPECT_EQ(joined.mesh.segment(kept).vertices[1], joined.vertices[c].back());
    }
}

}  // namespace
}  // namespace mq::triangulate
