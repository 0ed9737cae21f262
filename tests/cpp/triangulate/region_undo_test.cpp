// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/region_undo.h"

#include <random>
#include <set>

#include "triangulate/checks.h"
#include "triangulate/disc_change.h"

/// Changes that are taken back.
namespace mq::triangulate {
namespace {

std::set<std::array<int, 3>> sites_of(const mesh::SurfaceMesh& mesh) {
    std::set<std::array<int, 3>> all;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        if (!mesh.gone(t)) {
            std::array<int, 3> sites{mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)};
            std::rotate(sites.begin(), std::min_element(sites.begin(), sites.end()), sites.end());
            all.insert(sites);
        }
    }
    return all;
}

/// Any number of fans in the place of others, over each other or not: the same triangles are there again, under the
/// indices that are told, with their exemptions.
TEST(RegionUndo, BringsBackWhatWasThere) {
    std::mt19937 random(7);
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        pipeline.refine(25.0);
        mesh::SurfaceMesh& mesh = pipeline.surface;
        for (int round = 0; round < 10; ++round) {
            const auto before = sites_of(mesh);
            const int middle = static_cast<int>(random() % static_cast<unsigned>(mesh.triangle_count()));
            if (mesh.gone(middle)) {
                continue;
            }
            const int face = mesh.face_of(middle);
            const int first_site = mesh.site_of(3 * middle);
            pipeline.work.exempt[middle] = {Cause::Stuck, -1, -1, mesh.stamp(middle)};
            RegionUndo undo(pipeline.work);
            int next = middle;
            for (int change = 0; change < 6; ++change) {
                const auto disc = disc_of(mesh, triangles_around(mesh, 3 * next + static_cast<int>(random() % 3)));
                if (!disc) {
                    continue;
                }
                const mesh::SurfaceMesh::Site site = mesh.site(mesh.site_of(disc->rim.front()));
                const int vertex = mesh.add_vertex(site.point, {2, face});
                undo.about_to_remove(disc->triangles);
                const std::vector<int> added =
                    put_fan(pipeline.work, *disc, mesh.add_site({vertex, site.uv, site.normal}), 0.4);
                undo.added(added);
                next = added[random() % added.size()];
            }
            const std::map<int, int> moved = undo.undo();
            EXPECT_EQ(sites_of(mesh), before);
            const int again = moved.count(middle) > 0 ? moved.at(middle) : middle;
            EXPECT_EQ(mesh.site_of(3 * again), first_site);
            ASSERT_NE(pipeline.work.exemption_of(again), nullptr);
            EXPECT_EQ(pipeline.work.exemption_of(again)->cause, Cause::Stuck);
            EXPECT_EQ(mesh.inconsistency(), "");
            EXPECT_TRUE(pipeline.maxmin.doubled_edges().empty());
        }
    }
}

}  // namespace
}  // namespace mq::triangulate
