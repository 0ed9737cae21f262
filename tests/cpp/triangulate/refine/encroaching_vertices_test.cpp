// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/encroaching_vertices.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>
#include <vector>

#include "base/predicates.h"
#include "triangulate/checks.h"
#include "triangulate/operators/cavity_replacement.h"

namespace mq::triangulate {
namespace {

/// Counts the vertices inside faces that encroach upon segments, once for each side of each segment.
int encroaching(const ClassifiedMesh& mesh) {
    int count = 0;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        for (const ClassifiedMesh::SegmentUse& use : mesh.segment(s).uses) {
            const int h = use.half_edge;
            const int apex = ClassifiedMesh::prev(h);
            count += mesh.vertex(mesh.vertex_of(apex)).entity[0] == 2 &&
                     encroached(mesh.point_of(h), mesh.point_of(ClassifiedMesh::next(h)), mesh.point_of(apex));
        }
    }
    return count;
}

TEST(EncroachingVertices, AreRemovedFromTheInitialTriangulation) {
    int before = 0;
    int after = 0;
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        const int segments = pipeline.surface.segment_count();
        before += encroaching(pipeline.surface);
        remove_encroaching_vertices(pipeline.work);
        after += encroaching(pipeline.surface);
        EXPECT_EQ(pipeline.surface.inconsistency(), "");
        EXPECT_EQ(pipeline.surface.used_triangle_count(), pipeline.surface.triangle_count());
        EXPECT_EQ(pipeline.surface.segment_count(), segments);
        EXPECT_TRUE(pipeline.maxmin.doubled_edges().empty());
    }
    EXPECT_LT(after, before / 2);
}

/// Removals leave unused indices, into which the last triangles move: a list of all triangles must still name each.
TEST(EncroachingVertices, ListsOfTrianglesFollowThoseThatMove) {
    std::size_t unused = 0;
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        const ClassifiedMesh& mesh = pipeline.surface;
        std::vector<int> touched(static_cast<std::size_t>(mesh.triangle_count()));
        std::iota(touched.begin(), touched.end(), 0);
        for (int s = 0; s < mesh.segment_count(); ++s) {
            remove_encroaching_vertices(pipeline.work, s, touched);
        }
        unused += static_cast<std::size_t>(mesh.triangle_count() - mesh.used_triangle_count());
        close_gaps(pipeline.work, touched);
        const std::set<int> named(touched.begin(), touched.end());
        EXPECT_EQ(named.size(), static_cast<std::size_t>(mesh.triangle_count()));
        EXPECT_EQ(*named.rbegin(), mesh.triangle_count() - 1);
        EXPECT_EQ(mesh.inconsistency(), "");
    }
    EXPECT_GT(unused, 0u);
}

}  // namespace
}  // namespace mq::triangulate
