// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/rounds/mesh_blocks.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "base/parallel.h"
#include "geometry/analytic/analytic_model.h"
#include "triangulate/checks.h"
#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/rounds/block_round.h"

namespace mq::triangulate {
namespace {

constexpr std::size_t kBlocks = 5;

/// A torus of about a thousand triangles with good angles, whose seams are segments.
std::unique_ptr<Pipeline> torus() {
    auto pipeline = std::make_unique<Pipeline>(geometry::make_torus(5.0, 1.5));
    pipeline->refine(28.0);
    return pipeline;
}

/// Inserts a vertex into every triangle of every block, near its centroid, on so many threads.
/// @return half-edges of the cuts
std::vector<int> insert_everywhere(Pipeline& pipeline, int threads) {
    const ThreadLimit limit(threads);
    Workspace& work = pipeline.work;
    ClassifiedMesh& mesh = work.mesh;
    MeshBlocks blocks(mesh, kBlocks);
    std::vector<std::vector<int>> of_block(kBlocks);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        of_block[blocks.block_of(t)].push_back(t);
    }
    std::vector<std::size_t> insertions;
    std::vector<std::unique_ptr<MaxMinSwaps>> swaps;
    for (const std::vector<int>& triangles : of_block) {
        insertions.push_back(triangles.size());
        swaps.push_back(std::make_unique<MaxMinSwaps>(mesh, work.maxmin));
    }
    blocks.reserve(insertions);
    parallel_for(static_cast<int>(kBlocks), [&](int k) {
        const auto b = static_cast<std::size_t>(k);
        const ClassifiedMesh::SharedEditing editing(blocks.share(b));
        Workspace own{work.session, work.grid, mesh, *swaps[b], work.progress, work.floor};
        std::vector<int> touched;
        for (const int t : of_block[b]) {
            const Vec3 centroid = (mesh.point_of(3 * t) + mesh.point_of(3 * t + 1) + mesh.point_of(3 * t + 2)) / 3.0;
            const ClassifiedMesh::VertexUse& corner = mesh.site(mesh.site_of(3 * t));
            insert_vertex(own, t, {centroid, corner.uv, doubled_area(mesh, t).normalized()}, touched);
        }
    });
    std::vector<int> cuts = blocks.join();
    for (std::size_t b = 0; b < kBlocks; ++b) {
        work.maxmin.adopt(*swaps[b], [&](int vertex) { return blocks.joined_vertex(b, vertex); });
    }
    return cuts;
}

std::vector<int> corners_and_numbers(const ClassifiedMesh& mesh) {
    std::vector<int> all;
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        all.insert(all.end(), {mesh.vertex_of(h), mesh.site_of(h), mesh.twin(h), mesh.number_of(h)});
    }
    return all;
}

TEST(MeshBlocks, EveryBlockHasAboutAsManyTriangles) {
    const auto pipeline = torus();
    const MeshBlocks blocks(pipeline->surface, kBlocks);
    std::vector<std::size_t> counts(kBlocks, 0);
    for (int t = 0; t < pipeline->surface.triangle_count(); ++t) {
        ++counts[blocks.block_of(t)];
    }
    const std::size_t even = static_cast<std::size_t>(pipeline->surface.triangle_count()) / kBlocks;
    for (const std::size_t count : counts) {
        EXPECT_GT(count, even / 2);
        EXPECT_LT(count, 2 * even);
    }
}

TEST(MeshBlocks, CutsConstrainUntilTheyAreJoined) {
    const auto pipeline = torus();
    ClassifiedMesh& mesh = pipeline->surface;
    const std::vector<int> before = corners_and_numbers(mesh);
    const int segments = mesh.segment_count();
    MeshBlocks blocks(mesh, kBlocks);
    EXPECT_EQ(mesh.inconsistency(), "");
    EXPECT_GT(mesh.segment_count(), segments);
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        if (mesh.twin(h) >= 0) {
            ASSERT_EQ(blocks.block_of(h / 3), blocks.block_of(mesh.twin(h) / 3));
        }
    }
    blocks.reserve(std::vector<std::size_t>(kBlocks, 7));
    const std::vector<int> cuts = blocks.join();
    EXPECT_FALSE(cuts.empty());
    EXPECT_EQ(mesh.segment_count(), segments);
    EXPECT_EQ(corners_and_numbers(mesh), before);
}

TEST(MeshBlocks, TheMeshIsWholeAfterInsertionsInAllBlocks) {
    const auto pipeline = torus();
    ClassifiedMesh& mesh = pipeline->surface;
    const int triangles = mesh.triangle_count();
    const int vertices = mesh.vertex_count();
    std::vector<int> stack = insert_everywhere(*pipeline, 3);
    EXPECT_EQ(mesh.inconsistency(), "");
    const int added = mesh.vertex_count() - vertices;
    EXPECT_GT(added, triangles / 2);
    EXPECT_EQ(mesh.triangle_count(), triangles + 2 * added);
    EXPECT_EQ(mesh.used_triangle_count(), mesh.triangle_count());
    // The table of joined vertices is that of the mesh.
    const MaxMinSwaps anew(mesh);
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        const int a = mesh.vertex_of(h);
        const int far = mesh.vertex_of(ClassifiedMesh::prev(mesh.twin(h) < 0 ? h : mesh.twin(h)));
        ASSERT_EQ(pipeline->maxmin.joined(a, mesh.vertex_of(ClassifiedMesh::next(h))),
                  anew.joined(a, mesh.vertex_of(ClassifiedMesh::next(h))));
        ASSERT_EQ(pipeline->maxmin.joined(a, far), anew.joined(a, far));
    }
    EXPECT_EQ(pipeline->maxmin.doubled_edges(), anew.doubled_edges());
    std::vector<int> touched;
    pipeline->maxmin.restore(stack, touched);
    EXPECT_EQ(mesh.inconsistency(), "");
}

TEST(MeshBlocks, TheMeshIsTheSameForAnyNumberOfThreads) {
    const auto one = torus();
    insert_everywhere(*one, 1);
    for (const int threads : {2, 3, 8}) {
        const auto other = torus();
        insert_everywhere(*other, threads);
        EXPECT_EQ(corners_and_numbers(other->surface), corners_and_numbers(one->surface));
        EXPECT_EQ(other->surface.points(), one->surface.points());
    }
}

TEST(MeshBlocks, BlocksPayWhereThereIsEnoughToDo) {
    const auto pipeline = torus();
    EXPECT_EQ(blocks_for(pipeline->work, kInsertionsInRound - 1), 1U);
    EXPECT_EQ(blocks_for(pipeline->work, kInsertionsInRound), 4U);
    const int t = 5;
    const std::array<int, 3> split = pipeline->surface.split_triangle(
        t, pipeline->surface.add_site({pipeline->surface.add_vertex({}, {2, 0}), {}, {}}));
    pipeline->surface.replace({split[1], split[2]},
                              {{pipeline->surface.site_of(3 * split[1]), pipeline->surface.site_of(3 * split[1] + 1),
                                pipeline->surface.site_of(3 * split[2] + 1)}});
    EXPECT_EQ(blocks_for(pipeline->work, kInsertionsInRound), 1U) << "an index of a triangle is unused";
}

// Indices that were dropped must not get the marks of their former triangles.
TEST(MeshBlocks, NewTrianglesHaveNewVersions) {
    const auto pipeline = torus();
    ClassifiedMesh& mesh = pipeline->surface;
    const int count = mesh.triangle_count();
    TriangleMarks marks;
    for (const int removed : {3, 4}) {
        const std::array<int, 3> split =
            mesh.split_triangle(removed, mesh.add_site({mesh.add_vertex(mesh.point_of(0), {2, 0}), {}, {}}));
        marks.mark(mesh, split[1]);
        marks.mark(mesh, split[2]);
        std::array<int, 3> corners{};
        for (int k = 0; k < 3; ++k) {
            corners[static_cast<std::size_t>(k)] = mesh.site_of(3 * split[static_cast<std::size_t>(k)]);
        }
        mesh.replace({split[0], split[1], split[2]}, {corners});
        mesh.compact();
    }
    ASSERT_EQ(mesh.triangle_count(), count);
    insert_everywhere(*pipeline, 2);
    ASSERT_GT(mesh.triangle_count(), count + 4);
    for (int t = count; t < mesh.triangle_count(); ++t) {
        ASSERT_FALSE(marks.marked(mesh, t));
    }
}

// A sphere that is fine enough for blocks: as good as without them, and the same for any number of threads.
TEST(MeshBlocks, ChordsAreSplitInBlocks) {
    TriangulateOptions options;
    options.min_angle = 25.0;
    options.chord_height = 5e-5;
    options.threads = 1;
    const Result one = mesh_of(geometry::make_sphere(2.0), options, geometry::Engine::Mode::Threaded);
    EXPECT_GT(one.mesh.triangles.size(), 60'000U);
    EXPECT_GE(one.report.min_angle, 25.0);
    EXPECT_LE(one.report.max_chord_height, 5e-5);
    EXPECT_EQ(one.report.self_intersections, 0);
    options.threads = 3;
    const Result several = mesh_of(geometry::make_sphere(2.0), options, geometry::Engine::Mode::Threaded);
    EXPECT_EQ(several.mesh.vertices, one.mesh.vertices);
    EXPECT_EQ(several.mesh.triangles, one.mesh.triangles);
}

}  // namespace
}  // namespace mq::triangulate
