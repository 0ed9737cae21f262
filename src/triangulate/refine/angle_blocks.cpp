// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <utility>

#include "triangulate/refine/angle_refinement.h"
#include "triangulate/rounds/block_round.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

// Returns the lowest dimension of the CAD entities on which the corners of a triangle lie: 2 where all lie inside
// faces.
int lowest_entity(const ClassifiedMesh& mesh, int triangle) {
    const auto entity = [&](int h) { return mesh.vertex(mesh.vertex_of(h)).entity[0]; };
    return std::min({entity(3 * triangle), entity(3 * triangle + 1), entity(3 * triangle + 2)});
}

}  // namespace

// Inserts vertices inside faces in blocks of the mesh, for the worst triangle of a block first, where nothing but
// triangles of the block is concerned. What else there is to do stays in the queue.
void AngleRefinement::refine_in_blocks() {
    constexpr std::size_t kRoom = 2;  // vertices for a bad triangle: most need one or none
    const ClassifiedMesh& mesh = work_.mesh;
    std::vector<QueuedTriangle> left;
    std::vector<QueuedTriangle> inner;
    for (; !queue_.empty(); queue_.pop()) {
        const QueuedTriangle& bad = queue_.top();
        const bool there = mesh.stamp(bad.triangle) == bad.stamp;
        (there && lowest_entity(mesh, bad.triangle) == 2 ? inner : left).push_back(bad);
    }
    const std::size_t count = blocks_for(work_, inner.size());
    if (count == 1 || work_.triangles() + 2 * kRoom * inner.size() > work_.budget) {
        left.insert(left.end(), inner.begin(), inner.end());
        queue_ = Queue({}, std::move(left));
        return;
    }
    MeshBlocks blocks(work_.mesh, count);
    std::vector<std::vector<QueuedTriangle>> of_block(count);
    for (const QueuedTriangle& bad : inner) {
        of_block[blocks.block_of(bad.triangle)].push_back(bad);
    }
    std::vector<std::size_t> room;
    for (const std::vector<QueuedTriangle>& bad : of_block) {
        room.push_back(kRoom * bad.size());
    }
    work_.shrinks.resize(static_cast<std::size_t>(mesh.vertex_count()) + kRoom * inner.size(), 0);
    edit_in_blocks(work_, blocks, room, [&](geometry::Answerer& answerer, Workspace& block, std::size_t k) {
        refine_block(answerer, block, blocks.share(k), room[k], of_block[k]);
    });
    blocks.move_by_vertex(work_.shrinks);
    for (const std::vector<QueuedTriangle>& bad : of_block) {
        left.insert(left.end(), bad.begin(), bad.end());
    }
    queue_ = Queue({}, std::move(left));
    segments_.floors().check_after(inner.size());
    push_new();
}

// `bad` receives those that are left. Triangles that have changed are looked at anew afterwards.
void AngleRefinement::refine_block(geometry::Answerer& answerer, Workspace& block, const ClassifiedMesh::Share& share,
                                   std::size_t room, std::vector<QueuedTriangle>& bad) {
    Queue queue({}, std::move(bad));
    bad.clear();
    std::vector<int> touched;
    while (!queue.empty()) {
        block.progress.check();
        const QueuedTriangle worst = queue.top();
        queue.pop();
        if (block.mesh.stamp(worst.triangle) != worst.stamp) {
            continue;
        }
        touched = {worst.triangle};  // it is tried again if the site was inserted elsewhere
        const std::optional<int> shrinks =
            room > 0 ? insert_in_block(answerer, block, worst, touched) : std::optional<int>();
        if (!shrinks) {
            bad.push_back(worst);
            continue;
        }
        --room;
        work_.shrinks[static_cast<std::size_t>(share.vertex) - 1] = static_cast<std::uint8_t>(*shrinks);
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        for (const int t : touched) {
            if (const auto found = if_bad(t)) {
                queue.push(*found);
            }
        }
    }
    bad.erase(std::remove_if(bad.begin(), bad.end(),
                             [&](const QueuedTriangle& left) { return !looked_at_.marked(block.mesh, left.triangle); }),
              bad.end());
}

// Inserts the site of a triangle whose vertices lie inside a face, where no segment, node or cut is near.
// @return the insertions in its ancestry that made edges shorter; no value: nothing was inserted
std::optional<int> AngleRefinement::insert_in_block(geometry::Answerer& answerer, Workspace& block,
                                                    const QueuedTriangle& bad, std::vector<int>& touched) const {
    const ClassifiedMesh& mesh = block.mesh;
    if (bad.turned() || lowest_entity(mesh, bad.triangle) < 2) {
        return std::nullopt;
    }
    const Candidate site = off_centre_site(mesh, bad.triangle, bound_);
    const std::optional<SurfacePoint> p = surface_point(answerer, block, site);
    const Location place = p ? locate(mesh, site.triangle, *p) : Location();
    if (place.triangle < 0 || place.segment >= 0 || narrow_corner_of(mesh, place.triangle) >= 0) {
        return std::nullopt;
    }
    const Surroundings around = surroundings_of(mesh, place.triangle, p->point);
    const auto at_node = [&](int t) { return lowest_entity(mesh, t) == 0; };
    int shrinks = 0;
    if (!around.encroached.empty() || std::any_of(around.triangles.begin(), around.triangles.end(), at_node) ||
        around.nearest < segments_.floors().of(mesh.face_of(place.triangle)) ||
        crowded(bad.triangle, around.nearest, shrinks) || insert_vertex(block, place.triangle, *p, touched)) {
        return std::nullopt;
    }
    return shrinks;
}

}  // namespace mq::triangulate
