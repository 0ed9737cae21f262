// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <set>

#include "base/angle.h"
#include "triangulate/corner_angle.h"
#include "triangulate/disc_change.h"
#include "triangulate/mender.h"
#include "triangulate/segment_split.h"
#include "triangulate/side_length.h"

namespace mq::triangulate {

namespace {

using geometry::Query;
using mesh::SurfaceMesh;

// Where on the segment, of its parameters; and so many segments at a triangle.
constexpr std::array<double, 3> kFractions{0.5, 0.36, 0.64};
constexpr std::size_t kMostSegments = 8;
// By how much vertices move along their CAD edges, of the way to the next one either way.
constexpr std::array<double, 4> kMoves{-0.3, -0.15, 0.15, 0.3};

}  // namespace

// The longest first.
std::vector<int> Mender::segments_around(int triangle) const {
    const SurfaceMesh& mesh = work_.mesh;
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
    segments.resize(std::min(segments.size(), kMostSegments));
    return segments;
}

// Not where a triangle fills a narrow corner, nor on seams, nor where two of its triangles have the same third corner:
// the new vertex would be joined to that twice.
bool Mender::can_be_split(int segment) const {
    std::set<int> faces;
    std::set<int> third_corners;
    for (const SurfaceMesh::SegmentUse& use : work_.mesh.segment(segment).uses) {
        const int t = SurfaceMesh::triangle_of(use.half_edge);
        if (!faces.insert(work_.mesh.face_of(t)).second || narrow_corner_of(work_.mesh, t) >= 0 ||
            !third_corners.insert(work_.mesh.vertex_of(SurfaceMesh::prev(use.half_edge))).second) {
            return false;
        }
    }
    return !faces.empty();
}

// The smallest angle of the halves of the triangles beside it, as far as chords tell.
double Mender::angle_of_halves(int segment, double fraction) const {
    const SurfaceMesh& mesh = work_.mesh;
    const std::array<int, 2>& ends = mesh.segment(segment).vertices;
    const Vec3 a = mesh.vertex(ends[0]).point;
    const Vec3 b = mesh.vertex(ends[1]).point;
    const Vec3 middle = a + fraction * (b - a);
    double least = M_PI;
    for (const SurfaceMesh::SegmentUse& use : mesh.segment(segment).uses) {
        const Vec3& apex = mesh.point_of(SurfaceMesh::prev(use.half_edge));
        for (const Vec3& end : {a, b}) {
            least = std::min({least, angle_between(apex - end, middle - end),
                              angle_between(apex - middle, end - middle), angle_between(middle - apex, end - apex)});
        }
    }
    return least;
}

void Mender::add_splits(int triangle, std::vector<Kick>& kicks) const {
    for (const int segment : segments_around(triangle)) {
        if (!can_be_split(segment)) {
            continue;
        }
        for (const double fraction : kFractions) {
            Kick kick{{}, segment, fraction};
            kick.fan.angle = angle_of_halves(segment, fraction);
            kicks.push_back(kick);
        }
    }
}

// What a single move gains is done already: these make room for another vertex, beside it or opposite.
void Mender::add_moves(int triangle, std::vector<Kick>& kicks) const {
    const SurfaceMesh& mesh = work_.mesh;
    std::set<int> vertices;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        for (const int spoke : mesh.star(h)) {
            vertices.insert({mesh.vertex_of(spoke), mesh.vertex_of(SurfaceMesh::next(spoke)),
                             mesh.vertex_of(SurfaceMesh::prev(spoke))});
        }
    }
    for (const int v : vertices) {
        for (const double step : kMoves) {
            const std::optional<double> angle = slider_.angle_after(v, step, bound_);
            if (angle && *angle > kLeastOfKick * bound_) {
                Kick kick;
                kick.fan.angle = *angle;
                kick.vertex = v;
                kick.step = step;
                kicks.push_back(kick);
            }
        }
    }
}

bool Mender::move(int vertex, double step) {
    const std::vector<int> changed = slider_.move(vertex, step, bound_, undo_);
    undo_.added(changed);
    look_again_around(changed);
    return !changed.empty();
}

// At that fraction of its parameters.
bool Mender::split(int segment, double fraction) {
    SurfaceMesh& mesh = work_.mesh;
    const SurfaceMesh::Segment old = mesh.segment(segment);
    const double t = old.t[0] + fraction * (old.t[1] - old.t[0]);
    geometry::Engine::Batch batch{Query::edge_point(old.edge, t)};
    for (const SurfaceMesh::SegmentUse& use : old.uses) {
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
    std::vector<int> beside;
    for (const SurfaceMesh::SegmentUse& use : old.uses) {
        beside.push_back(SurfaceMesh::triangle_of(use.half_edge));
    }
    undo_.about_to_split(segment);
    const std::optional<Exemption> reason = take_exemptions(work_, beside);
    const int far = mesh.segment_count();
    const std::vector<int> halves = split_at(work_, segment, t, point, answers.data() + 1);
    undo_.added(halves);
    splits_.push_back({segment, far});
    exempt_bad(work_, halves, bound_, reason);
    look_again_around(halves);
    return std::all_of(halves.begin(), halves.end(), [&](int h) { return alignment(mesh, h) >= least_aligned_; });
}

}  // namespace mq::triangulate
