// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/virtual_topology/smooth_edge_removal.h"

#include <algorithm>
#include <set>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "triangulate/measure/self_intersections.h"
#include "triangulate/virtual_topology/smooth_edges.h"
#include "triangulate/virtual_topology/tuning.h"
#include "triangulate/virtual_topology/virtual_face_coarsening.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

// Corners between edges that no longer constrain the mesh do not justify an exemption.
void revoke_corner_exemptions(Workspace& work) {
    for (auto& [triangle, exemption] : work.exempt) {
        const int h = smallest_angle(work.mesh, triangle).half_edge;
        if (exemption.cause == Cause::NarrowCorner && exemption.stamp == work.mesh.stamp(triangle) &&
            (work.mesh.segment_of(h) < 0 || work.mesh.segment_of(ClassifiedMesh::prev(h)) < 0)) {
            exemption.cause = Cause::NoImprovingChange;
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

    void run(const TriangulateOptions& options, const Sizing& sizing, const std::set<int>& locked) {
        for (const int v : locked) {
            patches_.lock(v);
        }
        revoke_corner_exemptions(work_);
        if (!(sizing.growth > 0.0)) {  // larger triangles would exceed the growth bound
            VirtualFaceCoarsening(work_, options.min_angle, sizing, patches_).run();
        }
        work_.spanning = patches_.settle(work_);
    }

    // Returns the number of crossing pairs of triangles; `locked` receives the corners of changed ones.
    std::size_t crossings(std::set<int>& locked) {
        const auto pairs = SelfIntersections(work_).pairs();
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
    VirtualFaces patches_;
    MaxMinSwaps maxmin_;
    Workspace work_;
};

}  // namespace

Message remove_smooth_edges(Workspace& work, const TriangulateOptions& options, const Sizing& sizing) {
    const std::vector<char> smooth = smooth_edges(work, options.feature_angle, options.local_sizes);
    const auto released = static_cast<std::size_t>(std::count(smooth.begin(), smooth.end(), 1));
    if (released == 0) {
        return {};
    }
    const ClassifiedMesh before = work.mesh;
    const std::size_t crossings_before = SelfIntersections(work).pairs().size();
    std::set<int> locked;
    for (int i = 0; i < VirtualTopologyTuning::kMaxRemovalAttempts; ++i) {
        Attempt attempt(work, smooth, options.feature_angle);
        attempt.run(options, sizing, locked);
        if (attempt.crossings(locked) <= crossings_before) {
            work.exempt = std::move(attempt.work().exempt);
            work.spanning = std::move(attempt.work().spanning);
            return counted(phrases::kSmoothReleased, released, {{"count2", smooth.size()}});
        }
        work.mesh = before;
    }
    return counted(phrases::kSmoothKept, released, {{"count2", smooth.size()}});
}

}  // namespace mq::triangulate
