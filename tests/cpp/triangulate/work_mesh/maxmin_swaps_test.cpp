// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/maxmin_swaps.h"

#include <array>
#include <map>
#include <tuple>

#include "base/predicates.h"
#include "triangulate/checks.h"
#include "triangulate/work_mesh/surface_alignment.h"

namespace mq::triangulate {
namespace {

using geometry::Part;

/// Counts the edges and segments that join each pair of vertices.
std::map<std::pair<int, int>, int> joined_pairs(const ClassifiedMesh& mesh) {
    std::map<std::pair<int, int>, int> pairs;
    const auto add = [&](int a, int b) { ++pairs[std::minmax(a, b)]; };
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        if (mesh.twin(h) > h) {
            add(mesh.vertex_of(h), mesh.vertex_of(ClassifiedMesh::next(h)));
        }
    }
    for (int s = 0; s < mesh.segment_count(); ++s) {
        add(mesh.segment(s).vertices[0], mesh.segment(s).vertices[1]);
    }
    return pairs;
}

bool swap_folds(const ClassifiedMesh& mesh, int h) {
    const int g = mesh.twin(h);
    const Corner a = corner_of(mesh, mesh.site_of(h));
    const Corner b = corner_of(mesh, mesh.site_of(ClassifiedMesh::next(h)));
    const Corner c = corner_of(mesh, mesh.site_of(ClassifiedMesh::prev(h)));
    const Corner d = corner_of(mesh, mesh.site_of(ClassifiedMesh::prev(g)));
    const double after = std::min(alignment(a, d, c), alignment(d, b, c));
    const double before = std::min(alignment(a, b, c), alignment(b, a, d));
    return after < kAlignedSwap && (after < before || after <= -1.0);
}

/// Checks that no legal swap enlarges the smallest angle beside an edge.
void expect_maxmin(const ClassifiedMesh& mesh) {
    const auto pairs = joined_pairs(mesh);
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        const int g = mesh.twin(h);
        if (g < h) {
            continue;
        }
        const int c = mesh.vertex_of(ClassifiedMesh::prev(h));
        const int d = mesh.vertex_of(ClassifiedMesh::prev(g));
        const bool doubles = c == d || pairs.count(std::minmax(c, d)) > 0;
        EXPECT_TRUE(doubles || swap_folds(mesh, h) ||
                    locally_maxmin(mesh.point_of(h), mesh.point_of(ClassifiedMesh::next(h)),
                                   mesh.point_of(ClassifiedMesh::prev(h)), mesh.point_of(ClassifiedMesh::prev(g))))
            << "edge " << mesh.vertex_of(h) << "-" << mesh.vertex_of(g);
    }
}

void expect_no_doubled_edges(const ClassifiedMesh& mesh) {
    for (const auto& [ends, count] : joined_pairs(mesh)) {
        EXPECT_EQ(count, 1) << "edge " << ends.first << "-" << ends.second;
    }
}

TEST(MaxMinSwaps, HoldsAfterASweep) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        const auto before = joined_pairs(pipeline.surface);
        std::vector<int> touched;
        pipeline.maxmin.sweep(touched);
        EXPECT_EQ(pipeline.surface.inconsistency(), "");
        expect_maxmin(pipeline.surface);
        const auto doubled = [](const auto& pairs) {
            return std::count_if(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.second > 1; });
        };
        EXPECT_LE(doubled(joined_pairs(pipeline.surface)), doubled(before));
        touched.clear();
        pipeline.maxmin.sweep(touched);
        EXPECT_TRUE(touched.empty()) << "a second sweep finds more to swap";
    }
}

TEST(MaxMinSwaps, HoldsAfterRefinement) {
    for (const Insertion insertion : {Insertion::OffCentre, Insertion::Circumcentre}) {
        for (const Part& part : geometry::all_parts()) {
            SCOPED_TRACE(part.name);
            Pipeline pipeline(part.model);
            ASSERT_TRUE(pipeline.maxmin.doubled_edges().empty());
            pipeline.refine(28.0, insertion);
            EXPECT_EQ(pipeline.surface.inconsistency(), "");
            expect_maxmin(pipeline.surface);
            expect_no_doubled_edges(pipeline.surface);
        }
    }
}

TEST(MaxMinSwaps, ListsTheTrianglesThatASweepChanges) {
    Pipeline pipeline(geometry::make_torus(5.0, 1.5));
    ClassifiedMesh& mesh = pipeline.surface;
    std::vector<std::uint32_t> stamps;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        stamps.push_back(mesh.stamp(t));
    }
    std::vector<int> touched;
    pipeline.maxmin.sweep(touched);
    const std::set<int> listed(touched.begin(), touched.end());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        EXPECT_EQ(listed.count(t) > 0, mesh.stamp(t) != stamps[t]) << t;
    }
}

/// Five vertices in one plane as a closed surface, two of whose triangles lie over the other four: the edge 0-1 would
/// be swapped for its angles, if 2 and 3 were not joined on the other side already.
TEST(MaxMinSwaps, JoinsNoVerticesTwiceWhereTrianglesAreFolded) {
    ClassifiedMesh mesh;
    for (const auto& [x, y] : {std::pair(0.0, -1.0), {0.0, 1.0}, {-0.5, 0.0}, {0.5, 0.0}, {0.0, 5.0}, {0.0, -5.0}}) {
        const int vertex = mesh.add_vertex(Vec3(x, y, 0.0), {2, 0});
        mesh.add_site({vertex, Vec2(x, y), Vec3(0.0, 0.0, 1.0)});
    }
    const std::vector<std::array<int, 3>> corners{{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {1, 3, 4},
                                                  {2, 4, 3}, {0, 2, 5}, {2, 3, 5}, {3, 0, 5}};
    std::map<std::pair<int, int>, int> half_edges;
    for (const auto& c : corners) {
        const int t = mesh.add_triangle(c, 0);
        for (int i = 0; i < 3; ++i) {
            half_edges[{c[i], c[(i + 1) % 3]}] = 3 * t + i;
        }
    }
    for (const auto& [ends, h] : half_edges) {
        mesh.link(h, half_edges.at({ends.second, ends.first}));
    }
    ASSERT_EQ(mesh.inconsistency(), "");
    ASSERT_FALSE(locally_maxmin(mesh.point_of(0), mesh.point_of(1), mesh.point_of(2), mesh.point_of(5)));
    MaxMinSwaps maxmin(mesh);
    std::vector<int> touched;
    maxmin.sweep(touched);
    EXPECT_EQ(mesh.inconsistency(), "");
    expect_no_doubled_edges(mesh);
}

/// A band around a seam, two triangles wide: vertices 0 and 1 of the seam have sites on both sides of it, and the inner
/// vertex 2 is joined to each of them from both.
struct BandAroundASeam {
    ClassifiedMesh mesh;

    BandAroundASeam() {
        const std::array<int, 2> seam{mesh.add_vertex(Vec3(0, 0, 0), {0, 0}), mesh.add_vertex(Vec3(0, 1, 0), {0, 1})};
        const int inner = mesh.add_vertex(Vec3(1, 0.5, 0), {2, 0});
        for (const auto& [vertex, x, y] : {std::tuple(seam[0], 0.0, 0.0),
                                           {seam[1], 0.0, 1.0},
                                           {inner, 1.0, 0.5},
                                           {seam[0], 2.0, 0.0},
                                           {seam[1], 2.0, 1.0}}) {
            mesh.add_site({vertex, Vec2(x, y), Vec3(0, 0, 1)});
        }
        const int left = mesh.add_triangle({1, 0, 2}, 0);
        const int right = mesh.add_triangle({3, 4, 2}, 0);
        const int below = mesh.add_triangle({0, 3, 2}, 0);
        const int above = mesh.add_triangle({4, 1, 2}, 0);
        mesh.link(3 * left + 1, 3 * below + 2);
        mesh.link(3 * below + 1, 3 * right + 2);
        mesh.link(3 * right + 1, 3 * above + 2);
        mesh.link(3 * above + 1, 3 * left + 2);
    }
};

TEST(MaxMinSwaps, SeesEdgesOnTheTwoSidesOfASeam) {
    BandAroundASeam band;
    MaxMinSwaps maxmin(band.mesh);
    EXPECT_EQ(maxmin.doubled_edges().size(), 4u);
    EXPECT_TRUE(maxmin.joined(0, 2));
    const int site =
        band.mesh.add_site({band.mesh.add_vertex(Vec3(0.3, 0.5, 0), {2, 0}), Vec2(0.3, 0.5), Vec3(0, 0, 1)});
    maxmin.split_triangle(0, site);
    EXPECT_TRUE(maxmin.joined(0, 3));
    EXPECT_EQ(maxmin.doubled_edges().size(), 4u);
}

/// Triangles that are gone keep their links; counted, they made swaps illegal that are not.
TEST(MaxMinSwaps, ForgetsTrianglesThatAreGoneWhereTheTableIsRebuilt) {
    Pipeline pipeline(geometry::make_torus(5.0, 1.5));
    pipeline.refine(28.0, Insertion::OffCentre);
    ClassifiedMesh& mesh = pipeline.surface;
    int inner = -1;  // half-edge from a vertex inside a face, next to a border
    for (int h = 0; h < mesh.half_edge_count() && inner < 0; ++h) {
        if (mesh.vertex(mesh.vertex_of(h)).entity[0] == 2 &&
            mesh.vertex(mesh.vertex_of(ClassifiedMesh::next(h))).entity[0] < 2 && mesh.star(h).size() == 5) {
            inner = h;
        }
    }
    ASSERT_GE(inner, 0);
    std::vector<int> removed;
    std::vector<int> rim;
    for (const int spoke : mesh.star(inner)) {
        removed.push_back(ClassifiedMesh::triangle_of(spoke));
        rim.push_back(mesh.site_of(ClassifiedMesh::next(spoke)));
    }
    const int gone = mesh.vertex_of(inner);
    const int neighbour = mesh.vertex_of(ClassifiedMesh::next(inner));
    ASSERT_TRUE(pipeline.maxmin.joined(gone, neighbour));
    pipeline.maxmin.replace(removed, {{rim[0], rim[1], rim[2]}, {rim[0], rim[2], rim[3]}, {rim[0], rim[3], rim[4]}});
    EXPECT_FALSE(pipeline.maxmin.joined(gone, neighbour));
    EXPECT_FALSE(MaxMinSwaps(pipeline.surface).joined(gone, neighbour));
}

}  // namespace
}  // namespace mq::triangulate
