// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/segment_splitter.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "triangulate/operators/border_normals.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/refine/encroaching_vertices.h"
#include "triangulate/refine/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/surface_alignment.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Query;

// Least radius of the innermost shell in shortest lengths: any longer piece can be cut on a shell such that both parts
// are long enough, so that all edges of a corner can follow.
constexpr double kAboveFloor = 2.6;
// Length of the innermost pieces where a corner was cut off, in widths: they enclose 29 degrees and more.
constexpr double kOfWidth = 1.8;
constexpr double kOnShell = 1.01;  // tolerance of the intersection of a curve with a shell

// Returns the pairs of edges that meet in corners of faces narrow enough for a ladder, each in both orders.
std::set<std::array<int, 2>> ladders(const ClassifiedMesh& mesh) {
    std::set<std::array<int, 2>> pairs;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        for (int end = 0; end < 2; ++end) {
            for (const NarrowCorner& corner : corners_at(mesh, s, end)) {
                if (corner.angle < RefinementTuning::kWidestLadder) {
                    pairs.insert({mesh.segment(s).edge, mesh.segment(corner.segment).edge});
                }
            }
        }
    }
    return pairs;
}

}  // namespace

SegmentSplitter::SegmentSplitter(Workspace& work, bool guard_apexes, double bound)
    : work_(work),
      floors_(work, bound),
      guard_apexes_(guard_apexes),
      step_(guard_apexes && bound > 0.0 ? 1.0 / std::tan(bound + RefinementTuning::kLadderMargin) : 0.0),
      ladders_(step_ > 0.0 ? ladders(work.mesh) : std::set<std::array<int, 2>>()),
      shells_(corner_shells(work.mesh)) {
    for (double& radius : shells_.innermost) {
        radius = std::max(radius, kAboveFloor * work.shortest_allowed());
    }
    const geometry::Topology& topology = work.session.topology();
    for (int v = 0; v < work.mesh.vertex_count() && !topology.cut_corners.empty(); ++v) {
        const auto [dimension, node] = work.mesh.vertex(v).entity;
        const std::vector<int>& cut = topology.cut_corners;
        if (dimension == 0 && std::find(cut.begin(), cut.end(), node) != cut.end()) {
            double& radius = shells_.innermost[static_cast<std::size_t>(v)];
            radius = std::min(radius, kOfWidth * 2.0 * topology.nodes[static_cast<std::size_t>(node)].tolerance);
            cut_.insert(v);
        }
    }
    for (int s = 0; s < work.mesh.segment_count(); ++s) {
        for (int end = 0; end < 2; ++end) {
            double& radius = shells_.innermost[work.mesh.segment(s).vertices[end]];
            radius = std::max(radius, kOnShell * unresolved(s, end));
        }
    }
}

double SegmentSplitter::chord(int segment) const {
    const auto& v = work_.mesh.segment(segment).vertices;
    return (work_.mesh.vertex(v[1]).point - work_.mesh.vertex(v[0]).point).norm();
}

bool SegmentSplitter::encroached(int segment) const {
    const auto& uses = work_.mesh.segment(segment).uses;
    return std::any_of(uses.begin(), uses.end(), [&](const ClassifiedMesh::SegmentUse& use) {
        return apex_encroaches(work_.mesh, use.half_edge) &&
               !floors_.too_narrow(ClassifiedMesh::triangle_of(use.half_edge));
    });
}

SegmentSplitter::Shell SegmentSplitter::shell_of(int segment) const {
    const NarrowCorner corners[2] = {narrowest_corner(work_.mesh, segment, 0),
                                     narrowest_corner(work_.mesh, segment, 1)};
    const int end = corners[1].angle < corners[0].angle ? 1 : 0;
    if (corners[end].angle >= kAcuteCorner) {
        return {};
    }
    const double innermost = shells_.innermost[work_.mesh.segment(segment).vertices[end]];
    const double shell = innermost * std::exp2(std::round(std::log2(0.5 * chord(segment) / innermost)));
    // If the other edge at a small input angle is split more finely already, its innermost vertex determines the
    // shell: a chord that ends farther out could cross that edge.
    const double other = chord(corners[end].segment);
    return {end, corners[end].angle < kNarrowCorner && other < 0.7 * chord(segment) ? std::min(shell, other) : shell};
}

// Returns the place at which a piece between a vertex opposite to another one and the next such vertex ends: a piece
// as long as its distance from the other rail allows for the bound. None: the piece is shorter, or no rail of a ladder.
SegmentSplitter::Shell SegmentSplitter::rung_of(int segment) const {
    const ClassifiedMesh& mesh = work_.mesh;
    Shell best{-1, 0.5 * chord(segment)};
    for (const ClassifiedMesh::SegmentUse& use : mesh.segment(segment).uses) {
        const ClassifiedMesh::Vertex across = mesh.vertex(mesh.vertex_of(ClassifiedMesh::prev(use.half_edge)));
        if (across.entity[0] != 1 || ladders_.count({mesh.segment(segment).edge, across.entity[1]}) == 0) {
            continue;
        }
        for (int end = 0; end < 2; ++end) {
            const ClassifiedMesh::Vertex from = mesh.vertex(mesh.segment(segment).vertices[end]);
            const double width = std::max((from.point - across.point).norm(), work_.session.topology().detail);
            if (from.entity[0] == 1 && step_ * width < best.radius) {
                best = {end, step_ * width};
            }
        }
    }
    return best.end < 0 ? Shell{} : best;
}

bool SegmentSplitter::is_terminal(int segment, int* corner_vertex) const {
    for (int end = 0; end < 2; ++end) {
        const int v = work_.mesh.segment(segment).vertices[end];
        const bool innermost = v < static_cast<int>(shells_.innermost.size()) &&
                               chord(segment) <= kOnShell * shells_.innermost[v] &&
                               narrowest_corner(work_.mesh, segment, end).angle < kNarrowCorner;
        if (innermost || chord(segment) <= kOnShell * kOnShell * unresolved(segment, end)) {
            if (corner_vertex != nullptr) {
                *corner_vertex = v;
            }
            return true;
        }
    }
    return false;
}

bool SegmentSplitter::shrink_shell(int vertex) {
    int& left = halvings_left_.emplace(vertex, RefinementTuning::kMaxShellHalvings).first->second;
    double& radius = shells_.innermost[static_cast<std::size_t>(vertex)];
    if (left == 0 || 0.5 * radius < kAboveFloor * work_.shortest_allowed()) {
        return false;
    }
    --left;
    radius *= 0.5;
    return true;
}

bool SegmentSplitter::opens(int vertex, int segment) const {
    return cut_.count(vertex) > 0 && may_split(segment);
}

int SegmentSplitter::narrow_corner_near(const Vec3& p) const {
    for (const int v : shells_.narrow_nodes) {
        if ((work_.mesh.vertex(v).point - p).norm() <= RefinementTuning::kBesideShell * shells_.innermost[v]) {
            return v;
        }
    }
    return -1;
}

bool SegmentSplitter::in_diametral_lens(int segment, const Vec3& p) const {
    const auto& v = work_.mesh.segment(segment).vertices;
    const Vec3 a = work_.mesh.vertex(v[0]).point - p;
    const Vec3 b = work_.mesh.vertex(v[1]).point - p;
    return a.dot(b) < -0.5 * a.norm() * b.norm();
}

bool SegmentSplitter::may_split(int segment) const {
    return !obstacle(segment);
}

std::optional<Cause> SegmentSplitter::obstacle(int segment) const {
    if (const auto found = refusals_.find(segment); found != refusals_.end()) {
        return found->second;
    }
    if (is_terminal(segment)) {
        return Cause::NarrowCluster;
    }
    for (const ClassifiedMesh::SegmentUse& use : work_.mesh.segment(segment).uses) {
        if (is_apex_protected(use.half_edge) || is_apex_protected(ClassifiedMesh::next(use.half_edge))) {
            return Cause::Crowded;
        }
    }
    return floors_.too_short_to_split(segment, chord(segment)) ? std::optional(Cause::FaceFloorRaised) : std::nullopt;
}

bool SegmentSplitter::is_apex_protected(int h) const {
    return guard_apexes_ && ringed_apex(work_.mesh, h) && !is_free(work_.mesh.vertex_of(h));
}

void SegmentSplitter::request_at(int segment, int end, double distance) {
    asked_[segment] = {end, distance};
    request(segment, true);
}

void SegmentSplitter::request(int segment, bool force) {
    waiting_.resize(std::max<std::size_t>(waiting_.size(), work_.mesh.segment_count()), 0);
    if (!waiting_[segment] && (force ? !refused(segment) : may_split(segment))) {
        waiting_[segment] = 1;
        pending_.push_back(segment);
    }
}

bool SegmentSplitter::refused(int segment) const {
    const auto found = refusals_.find(segment);
    return found != refusals_.end() && (found->second != Cause::MinEdge || work_.too_short() == Cause::MinEdge);
}

void SegmentSplitter::run(std::vector<int>& touched) {
    while (!pending_.empty() && !work_.over_budget()) {
        split_pending(touched);
    }
}

void SegmentSplitter::split_pending(std::vector<int>& touched) {
    work_.progress.check();
    std::vector<int> now;
    now.swap(pending_);
    for (const int s : now) {
        waiting_[s] = 0;
    }
    std::vector<int> changed;
    split_batch(now, changed);
    touched.insert(touched.end(), changed.begin(), changed.end());
    if (work_.mesh.used_triangle_count() < work_.mesh.triangle_count()) {
        close_gaps(work_, touched);
        changed = touched;
    }
    request_encroached_around(changed);
}

void SegmentSplitter::request_encroached_around(const std::vector<int>& triangles) {
    for (const int t : triangles) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const int s = work_.mesh.segment_of(h);
            if (s >= 0 && encroached(s)) {
                request(s);
            }
        }
    }
}

Query SegmentSplitter::place_query(int segment) const {
    const ClassifiedMesh::Segment& s = work_.mesh.segment(segment);
    const Shell shell = place_of(segment);
    if (shell.end < 0) {
        return Query::edge_middle(s.edge, s.t[0], s.t[1]);
    }
    return Query::edge_at_distance(s.edge, s.t[shell.end], s.t[1 - shell.end], shell.radius);
}

void SegmentSplitter::split_batch(const std::vector<int>& segments, std::vector<int>& touched) {
    tried_ += segments.size();
    geometry::Engine::Batch batch;
    for (const int s : segments) {
        batch.push_back(place_query(s));
    }
    geometry::Engine::Answers places = work_.session.ask(std::move(batch));
    geometry::Engine::Batch on_faces;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const ClassifiedMesh::Segment& s = work_.mesh.segment(segments[i]);
        if (!places[i].found()) {  // a curve that leaves the shell and returns: it is split at its middle
            places[i] = work_.session.ask(Query::edge_middle(s.edge, s.t[0], s.t[1]));
        }
        for (const ClassifiedMesh::SegmentUse& use : s.uses) {
            on_faces.push_back(Query::use_on_face(use.use, places[i].t));
        }
    }
    geometry::Engine::Answers answers = work_.session.ask(std::move(on_faces));
    Answer* next = answers.data();
    std::vector<int> halves;
    for (std::size_t i = 0; i < segments.size() && !work_.over_budget(); ++i) {
        const std::size_t uses = work_.mesh.segment(segments[i]).uses.size();
        const Outcome outcome = split(segments[i], places[i], next, touched);
        if (outcome == Outcome::Split) {
            halves.insert(halves.end(), {segments[i], work_.mesh.segment_count() - 1});
        } else if (outcome != Outcome::Later && asked_.count(segments[i]) == 0) {
            refusals_[segments[i]] = outcome == Outcome::TooShort  ? work_.too_short()
                                     : outcome == Outcome::NoPoint ? Cause::NoSurfacePoint
                                                                   : Cause::Fold;
        }
        if (outcome != Outcome::Later) {
            asked_.erase(segments[i]);
        }
        next += uses;
    }
    for (const int s : halves) {  // after the loop, since their mates may have been among these segments
        remove_encroaching_vertices(work_, s, touched);
        enforce_equal_shells(s);
    }
}

void SegmentSplitter::enforce_equal_shells(int segment) {
    if (!is_terminal(segment)) {
        return;
    }
    for (int end = 0; end < 2; ++end) {
        for (const NarrowCorner& corner : corners_at(work_.mesh, segment, end)) {
            // Not if this piece would become the shorter one: the two would be split in turn without terminating.
            if (corner.angle < kNarrowCorner && chord(corner.segment) > RefinementTuning::kSameShell * chord(segment) &&
                RefinementTuning::kSameShell * shell_of(corner.segment).radius >= chord(segment)) {
                request(corner.segment, true);
            }
        }
    }
}

bool SegmentSplitter::on_curve(int segment, const Answer& place) const {
    const ClassifiedMesh::Segment& s = work_.mesh.segment(segment);
    return place.found() && place.t > std::min(s.t[0], s.t[1]) && place.t < std::max(s.t[0], s.t[1]);
}

bool SegmentSplitter::far_enough(int segment, const Vec3& point) const {
    const ClassifiedMesh::Segment& s = work_.mesh.segment(segment);
    const double least = work_.shortest_allowed();
    return (point - work_.mesh.vertex(s.vertices[0]).point).norm() >= std::max(least, unresolved(segment, 0)) &&
           (point - work_.mesh.vertex(s.vertices[1]).point).norm() >= std::max(least, unresolved(segment, 1));
}

// Returns the radius around that end within which the segment's edge has no vertices; 0 unless it is an end of the
// edge.
double SegmentSplitter::unresolved(int segment, int end) const {
    if (work_.unresolved.empty()) {
        return 0.0;
    }
    const ClassifiedMesh::Segment& s = work_.mesh.segment(segment);
    const geometry::Edge& edge = work_.session.topology().edges[s.edge];
    return s.t[end] == edge.t0 ? work_.unresolved[s.edge][0] : s.t[end] == edge.t1 ? work_.unresolved[s.edge][1] : 0.0;
}

// Returns the shell on which the segment is split; none: it is split in its middle. If the shell is too near to a node,
// the segment is split at the least distance from the node at which edges are told apart.
SegmentSplitter::Shell SegmentSplitter::place_of(int segment) const {
    const auto asked = asked_.find(segment);
    Shell shell = asked != asked_.end() ? asked->second : shell_of(segment);
    if (shell.end < 0 && step_ > 0.0) {
        shell = rung_of(segment);
    }
    for (int end = 0; end < 2; ++end) {
        const double least = kOnShell * unresolved(segment, end);
        if (shell.end < 0 && 0.5 * chord(segment) < least) {
            shell = {end, least};
        } else if (shell.end == end) {
            shell.radius = std::max(shell.radius, least);
        }
    }
    return shell;
}

// The new vertex lies beyond another segment: between two arcs whose chord errors are large against their distance,
// one has to be split before the other.
SegmentSplitter::Outcome SegmentSplitter::wait_for(int segment, int other) {
    if (other < 0 || other == segment || refused(other) || ++postponed_[segment] > RefinementTuning::kMaxPostponed) {
        return Outcome::Folds;
    }
    request(other, is_terminal(segment));
    request(segment, is_terminal(segment));
    return waiting_[other] != 0 ? Outcome::Later : Outcome::Folds;
}

// Returns the cavity of the new vertex on the face of one use. If the normal reverses beside the border, there is no
// cavity until the vertex gets the normal slightly inside.
InsertionCavity SegmentSplitter::cavity_for(int half_edge, const Vec3& point, Answer& on_face) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const int triangle = ClassifiedMesh::triangle_of(half_edge);
    const double least = std::min(RefinementTuning::kNotFolded, alignment(mesh, triangle));
    InsertionCavity cavity = grow_cavity(mesh, half_edge, true, {point, on_face.normal}, least);
    if (cavity.complete || !on_face.found()) {
        return cavity;
    }
    const ClassifiedMesh::VertexUse site{-1, Vec2(on_face.u, on_face.v), on_face.normal, point};
    const auto inner = interior_normal(work_, mesh.face_of(triangle), site, inward_step(mesh, half_edge));
    if (!inner) {
        return cavity;
    }
    on_face.normal = *inner;
    return grow_cavity(mesh, half_edge, true, {point, *inner}, least);
}

SegmentSplitter::Outcome SegmentSplitter::split(int segment, const Answer& place, Answer* on_faces,
                                                std::vector<int>& touched) {
    const Vec3 point = work_.grid.snap(place.point);
    if (!far_enough(segment, point)) {
        return Outcome::TooShort;
    }
    if (!on_curve(segment, place)) {
        return Outcome::NoPoint;
    }
    std::vector<InsertionCavity> cavities;
    std::set<int> taken;
    for (std::size_t k = 0; k < work_.mesh.segment(segment).uses.size(); ++k) {
        cavities.push_back(cavity_for(work_.mesh.segment(segment).uses[k].half_edge, point, on_faces[k]));
        if (!on_faces[k].found() || !cavities.back().complete) {
            return on_faces[k].found() ? wait_for(segment, cavities.back().segment) : Outcome::NoPoint;
        }
        for (const int t : cavities.back().triangles) {
            if (!taken.insert(t).second) {
                return Outcome::Folds;  // both sides of a seam need the same triangle
            }
        }
    }
    if (!work_.check_budget(work_.mesh.segment(segment).uses.size())) {
        return Outcome::Later;
    }
    insert(segment, place.t, point, on_faces, cavities, touched);
    return Outcome::Split;
}

void SegmentSplitter::insert(int segment, double t, const Vec3& point, const Answer* on_faces,
                             const std::vector<InsertionCavity>& cavities, std::vector<int>& touched) {
    const std::size_t before = touched.size();
    const std::vector<int> halves = split_at(work_, segment, t, point, on_faces);
    touched.insert(touched.end(), halves.begin(), halves.end());
    for (const InsertionCavity& cavity : cavities) {
        for (const int g : cavity.outside) {
            work_.maxmin.swap(g, touched);
        }
    }
    work_.maxmin.restore_around(before, touched);
    work_.angle_history.record(work_);
}

}  // namespace mq::triangulate
