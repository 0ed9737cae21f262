// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/edit_transaction.h"

#include <random>
#include <set>

#include "triangulate/checks.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/optimise/edge_vertex_relocation.h"

/// Changes that are undone.
namespace mq::triangulate {
namespace {

std::set<std::array<int, 3>> sites_of(const ClassifiedMesh& mesh) {
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

/// Replaces all triangles around the origin of `h` by a fan from a new vertex, if these are a disc. @return its
/// triangles
std::vector<int> put_new_fan(Pipeline& pipeline, int h, EditTransaction& undo) {
    ClassifiedMesh& mesh = pipeline.surface;
    const auto disc = disc_of(mesh, triangles_around(mesh, h));
    if (!disc) {
        return {};
    }
    const ClassifiedMesh::VertexUse site = mesh.site(mesh.site_of(disc->rim.front()));
    const int vertex = mesh.add_vertex(site.point, {2, mesh.face_of(h / 3)});
    undo.about_to_remove(disc->triangles);
    std::vector<int> added = replace_by_fan(pipeline.work, *disc, mesh.add_site({vertex, site.uv, site.normal}), 0.4);
    undo.added(added);
    return added;
}

/// After any number of fans, overlapping or not, undoing restores the same triangles, under the returned indices, with
/// their exemptions.
TEST(EditTransaction, BringsBackWhatWasThere) {
    std::mt19937 random(7);
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        pipeline.refine(25.0);
        ClassifiedMesh& mesh = pipeline.surface;
        for (int round = 0; round < 10; ++round) {
            const auto before = sites_of(mesh);
            const int middle = static_cast<int>(random() % static_cast<unsigned>(mesh.triangle_count()));
            if (mesh.gone(middle)) {
                continue;
            }
            const int first_site = mesh.site_of(3 * middle);
            pipeline.work.exempt[middle] = {Cause::NoImprovingChange, -1, -1, mesh.stamp(middle)};
            EditTransaction undo(pipeline.work);
            undo.begin();
            int next = middle;
            for (int change = 0; change < 6; ++change) {
                const std::vector<int> added = put_new_fan(pipeline, 3 * next + static_cast<int>(random() % 3), undo);
                next = added.empty() ? next : added[random() % added.size()];
            }
            const std::map<int, int> moved = undo.undo();
            EXPECT_FALSE(undo.is_open());
            EXPECT_EQ(sites_of(mesh), before);
            const int again = moved.count(middle) > 0 ? moved.at(middle) : middle;
            EXPECT_EQ(mesh.site_of(3 * again), first_site);
            ASSERT_NE(pipeline.work.exemption_of(again), nullptr);
            EXPECT_EQ(pipeline.work.exemption_of(again)->cause, Cause::NoImprovingChange);
            EXPECT_EQ(mesh.inconsistency(), "");
            EXPECT_TRUE(pipeline.maxmin.doubled_edges().empty());
        }
    }
}

using Ends = std::array<double, 5>;

std::set<Ends> segments_of(const ClassifiedMesh& mesh) {
    std::set<Ends> all;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = mesh.segment(s);
        if (!segment.uses.empty()) {
            all.insert({static_cast<double>(segment.edge), static_cast<double>(segment.vertices[0]),
                        static_cast<double>(segment.vertices[1]), segment.t[0], segment.t[1]});
        }
    }
    return all;
}

void random_fan(Pipeline& pipeline, std::mt19937& random, EditTransaction& undo) {
    ClassifiedMesh& mesh = pipeline.surface;
    const int t = static_cast<int>(random() % static_cast<unsigned>(mesh.triangle_count()));
    if (mesh.gone(t)) {
        return;
    }
    put_new_fan(pipeline, 3 * t + static_cast<int>(random() % 3), undo);
}

// Moves a vertex of a random triangle along its CAD edge, if one is on one, whatever its angles become. @return whether
// it has moved
bool random_move(Pipeline& pipeline, std::mt19937& random, const Sizing& sizing, EditTransaction& undo) {
    const int t = static_cast<int>(random() % static_cast<unsigned>(pipeline.surface.triangle_count()));
    if (pipeline.surface.gone(t)) {
        return false;
    }
    const std::vector<int> changed = EdgeVertexRelocation(pipeline.work, sizing)
                                         .improve(
                                             t, 0.4, [](double) { return 0.05; }, undo);
    undo.added(changed);
    return !changed.empty();
}

/// Fans and moves: undoing restores the state on all faces; what is committed stays.
TEST(EditTransaction, BringsBackPlacesOfVertices) {
    std::mt19937 random(11);
    int moves = 0;
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        pipeline.refine(25.0);
        ClassifiedMesh& mesh = pipeline.surface;
        const Sizing sizing{0.0, EdgeBounds(pipeline.session.topology(), 0.0, {}), 0.0, 0.0};
        EditTransaction undo(pipeline.work);
        for (int round = 0; round < 30; ++round) {
            const auto sites = sites_of(mesh);
            const auto segments = segments_of(mesh);
            undo.begin();
            random_fan(pipeline, random, undo);
            for (int k = 0; k < 5; ++k) {
                moves += random_move(pipeline, random, sizing, undo) ? 1 : 0;
            }
            random_fan(pipeline, random, undo);
            EXPECT_EQ(mesh.inconsistency(), "");
            if (round % 3 == 0) {
                const auto changed = sites_of(mesh);
                undo.commit();
                EXPECT_EQ(sites_of(mesh), changed);
            } else {
                undo.undo();
                EXPECT_EQ(sites_of(mesh), sites);
                EXPECT_EQ(segments_of(mesh), segments);
            }
            EXPECT_EQ(mesh.inconsistency(), "");
            mesh.compact();
            EXPECT_TRUE(pipeline.maxmin.doubled_edges().empty());
        }
    }
    EXPECT_GT(moves, 100);
}

}  // namespace
}  // namespace mq::triangulate
