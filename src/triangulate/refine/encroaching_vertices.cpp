// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/encroaching_vertices.h"

#include <algorithm>
#include <vector>

#include "base/predicates.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/operators/removal_cavity.h"

namespace mq::triangulate {

bool apex_encroaches(const ClassifiedMesh& mesh, int half_edge) {
    return encroached(mesh.point_of(half_edge), mesh.point_of(ClassifiedMesh::next(half_edge)),
                      mesh.point_of(ClassifiedMesh::prev(half_edge)));
}

namespace {

// Returns the half-edge that leaves the vertex inside a face that encroaches upon a use of a segment; -1: there is
// none.
int encroaching_spoke(const ClassifiedMesh& mesh, const ClassifiedMesh::SegmentUse& use) {
    const int spoke = ClassifiedMesh::prev(use.half_edge);
    const bool inside = mesh.vertex(mesh.vertex_of(spoke)).entity[0] == 2;
    return inside && apex_encroaches(mesh, use.half_edge) ? spoke : -1;
}

bool remove_vertex(Workspace& work, int spoke, std::vector<int>& touched) {
    const auto cavity = removal_cavity(work.mesh, spoke);
    if (!cavity || std::any_of(cavity->triangles.begin(), cavity->triangles.end(),
                               [&](int t) { return work.settled.marked(work.mesh, t); })) {
        return false;
    }
    const std::vector<Fan> fans = fans_of(work.mesh, *cavity, 0.0);
    const auto fan = std::find_if(fans.begin(), fans.end(), [&](const Fan& candidate) {
        return fan_aligned(work.mesh, *cavity, candidate, kWellAligned) &&
               fan_legal(work.mesh, work.maxmin, *cavity, candidate.apex_site);
    });
    if (fan == fans.end()) {
        return false;
    }
    withdraw_exemptions(work, cavity->triangles);
    const std::size_t before = touched.size();
    const std::vector<int> added = work.maxmin.replace(cavity->triangles, fan->triangles);
    touched.insert(touched.end(), added.begin(), added.end());
    work.maxmin.restore_around(before, touched);
    return true;
}

bool remove_one(Workspace& work, int segment, std::vector<int>& touched) {
    for (const ClassifiedMesh::SegmentUse& use : work.mesh.segment(segment).uses) {
        const int spoke = encroaching_spoke(work.mesh, use);
        if (spoke >= 0 && remove_vertex(work, spoke, touched)) {
            return true;  // the uses of the segment have changed
        }
    }
    return false;
}

}  // namespace

void remove_encroaching_vertices(Workspace& work, int segment, std::vector<int>& touched) {
    while (remove_one(work, segment, touched)) {
        work.progress.check();
    }
}

void remove_encroaching_vertices(Workspace& work) {
    CancelPace pace(work.progress);
    std::vector<int> touched;
    for (int s = 0; s < work.mesh.segment_count(); ++s) {
        pace.step();
        remove_encroaching_vertices(work, s, touched);
    }
    close_gaps(work);
}

}  // namespace mq::triangulate
