// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <set>

#include "base/angle.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/optimise/cavity_optimiser.h"
#include "triangulate/optimise/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

using geometry::Query;

// Returns the segments around a triangle, the longest first.
std::vector<int> CavityOptimiser::segments_around(int triangle) const {
    const ClassifiedMesh& mesh = work_.mesh;
    std::set<int> found;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        for (const int t : triangles_around(mesh, h)) {
            for (int k = 3 * t; k < 3 * t + 3; ++k) {
                if (mesh.segment_of(k) >= 0) {
                    found.insert(mesh.segment_of(k));
                }
            }
        }
    }
    std::vector<int> segments(found.begin(), found.end());
    const auto length = [&](int s) { return side_length(mesh, mesh.segment(s).uses.front().half_edge); };
    std::stable_sort(segments.begin(), segments.end(), [&](int a, int b) { return length(a) > length(b); });
    segments.resize(std::min(segments.size(), OptimisationTuning::kMaxSegments));
    return segments;
}

// Excludes segments of triangles at small input angles, seams, and segments whose triangles share their third corner:
// the new vertex would be joined to that corner twice.
bool CavityOptimiser::can_be_split(int segment) const {
    std::set<int> faces;
    std::set<int> third_corners;
    for (const ClassifiedMesh::SegmentUse& use : work_.mesh.segment(segment).uses) {
        const int t = ClassifiedMesh::triangle_of(use.half_edge);
        if (!faces.insert(work_.mesh.face_of(t)).second || narrow_corner_of(work_.mesh, t) >= 0 ||
            !third_corners.insert(work_.mesh.vertex_of(ClassifiedMesh::prev(use.half_edge))).second) {
            return false;
        }
    }
    return !faces.empty();
}

// Returns the smallest angle of the halves of the adjacent triangles, measured on chords, radians.
double CavityOptimiser::angle_of_halves(int segment, double fraction) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const std::array<int, 2>& ends = mesh.segment(segment).vertices;
    const Vec3 a = mesh.vertex(ends[0]).point;
    const Vec3 b = mesh.vertex(ends[1]).point;
    const Vec3 middle = a + fraction * (b - a);
    double least = M_PI;
    for (const ClassifiedMesh::SegmentUse& use : mesh.segment(segment).uses) {
        const Vec3& apex = mesh.point_of(ClassifiedMesh::prev(use.half_edge));
        for (const Vec3& end : {a, b}) {
            least = std::min({least, angle_between(apex - end, middle - end),
                              angle_between(apex - middle, end - middle), angle_between(middle - apex, end - apex)});
        }
    }
    return least;
}

void CavityOptimiser::add_splits(int triangle, std::vector<Perturbation>& kicks) const {
    for (const int segment : segments_around(triangle)) {
        if (!can_be_split(segment)) {
            continue;
        }
        for (const double fraction : OptimisationTuning::kSplitFractions) {
            Perturbation kick{{}, segment, fraction};
            kick.fan.angle = angle_of_halves(segment, fraction);
            kicks.push_back(kick);
        }
    }
}

// Moves that improve angles at once were made before: these make space for another vertex, beside it or opposite.
void CavityOptimiser::add_moves(int triangle, std::vector<Perturbation>& kicks) const {
    const ClassifiedMesh& mesh = work_.mesh;
    std::set<int> vertices;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        for (const int spoke : mesh.star(h)) {
            vertices.insert({mesh.vertex_of(spoke), mesh.vertex_of(ClassifiedMesh::next(spoke)),
                             mesh.vertex_of(ClassifiedMesh::prev(spoke))});
        }
    }
    for (const int v : vertices) {
        for (const double step : OptimisationTuning::kMoves) {
            const std::optional<double> angle = slider_.angle_after(v, step, bound_);
            if (angle && *angle > OptimisationTuning::kLeastOfPerturbation * bound_) {
                Perturbation kick;
                kick.fan.angle = *angle;
                kick.vertex = v;
                kick.step = step;
                kicks.push_back(kick);
            }
        }
    }
}

bool CavityOptimiser::move(int vertex, double step) {
    const std::vector<int> changed = slider_.move(vertex, step, bound_, undo_);
    undo_.added(changed);
    requeue_around(changed);
    return !changed.empty();
}

// Splits the segment at that fraction of its parameter range.
bool CavityOptimiser::split(int segment, double fraction) {
    ClassifiedMesh& mesh = work_.mesh;
    const ClassifiedMesh::Segment old = mesh.segment(segment);
    const double t = old.t[0] + fraction * (old.t[1] - old.t[0]);
    geometry::Engine::Batch batch{Query::edge_point(old.edge, t)};
    for (const ClassifiedMesh::SegmentUse& use : old.uses) {
        batch.push_back(Query::use_on_face(use.use, t));
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(batch));
    if (!std::all_of(answers.begin(), answers.end(), [](const geometry::Answer& a) { return a.found(); })) {
        return false;
    }
    const Vec3 point = work_.grid.snap(answers.front().point);
    for (const int end : old.vertices) {
        if ((mesh.vertex(end).point - point).norm() < work_.shortest_allowed()) {
            return false;
        }
    }
    if (!work_.check_budget(old.uses.size())) {
        return false;
    }
    std::vector<int> beside;
    for (const ClassifiedMesh::SegmentUse& use : old.uses) {
        beside.push_back(ClassifiedMesh::triangle_of(use.half_edge));
    }
    undo_.about_to_split(segment);
    const std::optional<Exemption> reason = withdraw_exemptions(work_, beside);
    const int far = mesh.segment_count();
    const std::vector<int> halves = split_at(work_, segment, t, point, answers.data() + 1);
    undo_.added(halves);
    split_ = {segment, far};
    restore_exemptions(work_, halves, bound_, reason);
    requeue_around(halves);
    return std::all_of(halves.begin(), halves.end(), [&](int h) { return alignment(mesh, h) >= least_aligned_; });
}

}  // namespace mq::triangulate
