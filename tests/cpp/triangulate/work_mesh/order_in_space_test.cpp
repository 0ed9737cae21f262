// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>
#include <vector>

#include "triangulate/work_mesh/classified_mesh.h"
#include "triangulate/work_mesh/mesh_shaker.h"

namespace mq::triangulate {
namespace {

/// The corners' (u, v) and the face of every triangle, whatever its index.
std::multiset<std::vector<double>> contents(const ClassifiedMesh& mesh) {
    std::multiset<std::vector<double>> result;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        std::vector<double> content{static_cast<double>(mesh.face_of(t)), static_cast<double>(mesh.stamp(t))};
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const Vec2& uv = mesh.site(mesh.site_of(h)).uv;
            const Vec3 p = mesh.vertex(mesh.vertex_of(h)).point;
            content.insert(content.end(), {uv.x(), uv.y(), p.x(), p.y(), p.z()});
            content.push_back(mesh.segment_of(h));
        }
        result.insert(content);
    }
    return result;
}

TEST(ClassifiedMesh, OrderInSpaceChangesIndicesOnly) {
    for (const Sample& sample : all_samples()) {
        SCOPED_TRACE(sample.name);
        ClassifiedMesh mesh = sample.mesh;
        const int vertices = mesh.vertex_count();
        const int sites = mesh.site_count();
        Shaker shaker(mesh, 12);
        for (int i = 0; i < 100; ++i) {
            shaker.step();
        }
        const auto before = contents(mesh);
        const int segments = mesh.segment_count();
        const int edges = mesh.edge_count();
        const std::int64_t made = mesh.edges_made();
        LargeVector<std::uint32_t> of_triangles;
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            of_triangles.push_back(mesh.stamp(t));
        }
        std::vector<Vec3> of_vertices = mesh.points();
        const NewIndices renewed = mesh.order_in_space(vertices, sites);
        EXPECT_EQ(mesh.inconsistency(), "");
        EXPECT_EQ(contents(mesh), before);
        EXPECT_EQ(mesh.segment_count(), segments);
        EXPECT_EQ(mesh.number_count(), edges);
        EXPECT_GT(mesh.edges_made(), made);
        for (int v = 0; v < vertices; ++v) {
            ASSERT_EQ(renewed.vertices[static_cast<std::size_t>(v)], v);
        }
        for (int s = 0; s < sites; ++s) {
            ASSERT_EQ(renewed.sites[static_cast<std::size_t>(s)], s);
        }
        move_to_indices(renewed.triangles, of_triangles, 0U);
        move_to_indices(renewed.vertices, of_vertices, Vec3::Zero());
        EXPECT_EQ(of_vertices, mesh.points());
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            ASSERT_EQ(of_triangles[static_cast<std::size_t>(t)], mesh.stamp(t));
        }
    }
}

TEST(ClassifiedMesh, OrderInSpaceBringsNeighboursTogether) {
    ClassifiedMesh mesh = samples::sheet(64, 64);
    const auto far_apart = [&] {  // pairs of triangles beside each other whose indices are not near
        int count = 0;
        for (int h = 0; h < mesh.half_edge_count(); ++h) {
            count += mesh.twin(h) > h && std::abs(mesh.twin(h) / 3 - h / 3) > 64 ? 1 : 0;
        }
        return count;
    };
    const int by_rows = far_apart();
    mesh.order_in_space(0, 0);
    EXPECT_LT(far_apart(), by_rows / 2);
    EXPECT_EQ(mesh.inconsistency(), "");
}

TEST(ClassifiedMesh, OrderInSpaceDropsVerticesWithoutTriangles) {
    ClassifiedMesh mesh = samples::sheet(3, 2);
    const int vertices = mesh.vertex_count();
    const int alone = mesh.add_vertex(Vec3(0.5, 0.5, 0.0), {2, 0});
    mesh.add_site({alone, Vec2(0.5, 0.5), Vec3::UnitZ(), Vec3::Zero()});
    const NewIndices renewed = mesh.order_in_space(0, 0);
    EXPECT_EQ(mesh.vertex_count(), vertices);
    EXPECT_EQ(renewed.vertices[static_cast<std::size_t>(alone)], -1);
    EXPECT_EQ(mesh.inconsistency(), "");
}

TEST(NewIndices, MoveDataThatAreThere) {
    const LargeVector<int> renewed{2, -1, 0, 4, 1, 3, -1};
    std::vector<int> values{10, 11, 12, 13, 14};  // the last two have none
    move_to_indices(renewed, values, -1);
    EXPECT_EQ(values, (std::vector<int>{12, 14, 10, -1, 13}));
    std::map<int, int> sparse{{1, 5}, {2, 6}, {5, 7}, {9, 8}};
    move_to_indices(renewed, sparse);
    EXPECT_EQ(sparse, (std::map<int, int>{{0, 6}, {3, 7}}));
}

}  // namespace
}  // namespace mq::triangulate
