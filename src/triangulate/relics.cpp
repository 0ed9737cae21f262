// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/relics.h"

#include <algorithm>
#include <set>

#include "triangulate/corner_angle.h"
#include "triangulate/crossing_finder.h"
#include "triangulate/patch_coarsener.h"
#include "triangulate/smooth_edges.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

// Where released faces cross, the vertices there are locked and all is done again.
constexpr int kMaxAttempts = 4;

// Corners between edges that do not constrain any longer are no excuse.
void withdraw_corners(Workspace& work) {
    for (auto& [triangle, exemption] : work.exempt) {
        const int h = smallest_angle(work.mesh, triangle).half_edge;
        if (exemption.cause == Cause::NarrowCorner && exemption.stamp == work.mesh.stamp(triangle) &&
            (work.mesh.segment_of(h) < 0 || work.mesh.segment_of(SurfaceMesh::prev(h)) < 0)) {
            exemption.cause = Cause::Stuck;
        }
    }
}

class Attempt {
  public:
    Attempt(Workspace& whole, const std::vector<char>& smooth, double feature_angle)
        : patches_(whole.mesh, smooth, feature_angle),
          maxmin_(whole.mesh),
          work_{whole.session, whole.grid,    whole.mesh,   maxmin_, whole.progress, whole.floor, whole.min_edge,
                whole.budget,  whole.shrinks, whole.exempt, {}} {}

    void run(const Options& options, const Sizing& sizing, const std::set<int>& locked) {
        for (const int v : locked) {
            patches_.lock(v);
        }
        withdraw_corners(work_);
        if (!(sizing.growth > 0.0)) {  // larger triangles would grow faster than asked for
            PatchCoarsener(work_, options.min_angle, sizing, patches_).run();
        }
        work_.spanning = patches_.settle(work_);
    }

    // Pairs of triangles that cross; `locked` takes the corners of those that were changed.
    std::size_t crossings(std::set<int>& locked) {
        const auto pairs = CrossingFinder(work_).pairs();
        for (const auto& pair : pairs) {
            for (const int t : pair) {
                for (int h = 3 * t; patches_.changed(t) && h < 3 * t + 3; ++h) {
                    locked.insert(work_.mesh.vertex_of(h));
                }
            }
        }
        return pairs.size();
    }

    Workspace& work() { return work_; }

  private:
    Patches patches_;
    Maxmin maxmin_;
    Workspace work_;
};

}  // namespace

std::string release_relics(Workspace& work, const Options& options, const Sizing& sizing) {
    const std::vector<char> smooth = smooth_edges(work, options.feature_angle, options.local_sizes);
    const auto released = std::count(smooth.begin(), smooth.end(), 1);
    if (released == 0) {
        return {};
    }
    const bool one = released == 1;
    const std::string what = std::to_string(released) + " of " + std::to_string(smooth.size()) +
                             (one ? " edges is smooth" : " edges are smooth");
    const SurfaceMesh before = work.mesh;
    const std::size_t crossings_before = CrossingFinder(work).pairs().size();
    std::set<int> locked;
    for (int i = 0; i < kMaxAttempts; ++i) {
        Attempt attempt(work, smooth, options.feature_angle);
        attempt.run(options, sizing, locked);
        if (attempt.crossings(locked) <= crossings_before) {
            work.exempt = std::move(attempt.work().exempt);
            work.spanning = std::move(attempt.work().spanning);
            return what + (one ? " and does not" : " and do not") + " constrain the mesh (keep_edges = feature)";
        }
        work.mesh = before;
    }
    return what + (one ? ", but constrains" : ", but constrain") +
           " the mesh all the same: otherwise faces would cross";
}

ChordHeight farthest_spanning(Workspace& work) {
    ChordHeight worst;
    const SurfaceMesh& mesh = work.mesh;
    for (const auto& [triangle, span] : work.spanning) {
        const Vec3& a = mesh.point_of(3 * triangle);
        const Vec3& b = mesh.point_of(3 * triangle + 1);
        const Vec3& c = mesh.point_of(3 * triangle + 2);
        std::vector<Vec3> points;
        sample_triangle(a, b, c, points);
        sample_edge(a, b, points);
        sample_edge(b, c, points);
        sample_edge(c, a, points);
        const std::vector<Foot> feet = feet_on(work, points, span.sheets);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (feet[i].found() && (worst.triangle < 0 || feet[i].distance > worst.distance)) {
                worst = {feet[i].distance, triangle, work.grid.to_part(points[i])};
            }
        }
    }
    return worst;
}

}  // namespace mq::triangulate
