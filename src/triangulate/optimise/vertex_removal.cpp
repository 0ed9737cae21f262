// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/optimise/vertex_removal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/angle.h"
#include "base/parallel.h"
#include "triangulate/measure/backward_distance.h"
#include "triangulate/measure/deviation_peaks.h"
#include "triangulate/measure/distance_probes.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/optimise/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/incident_segments.h"

namespace mq::triangulate {

namespace {

constexpr double kExact = 2.0;  // resolutions of the grid: rounding of vertices on plane faces

}  // namespace

VertexRemoval::VertexRemoval(Workspace& work, const ChordErrorCache& measure, double min_angle_degrees,
                             const Sizing& sizing, int first_vertex)
    : work_(work),
      measure_(measure),
      bound_(min_angle_degrees * kDegree),
      least_angle_(OptimisationTuning::kRemovalMargin * bound_),
      sizing_(sizing),
      first_vertex_(first_vertex),
      most_spokes_(static_cast<int>(M_PI / least_angle_)) {}

void VertexRemoval::find_places() {
    const ClassifiedMesh& mesh = work_.mesh;
    half_edge_of_.assign(static_cast<std::size_t>(mesh.vertex_count()), -1);
    segments_at_ = segments_at_vertices(mesh);
    for (int h = mesh.half_edge_count() - 1; h >= 0; --h) {
        half_edge_of_[static_cast<std::size_t>(mesh.vertex_of(h))] = h;
    }
}

// Decides by the cached chord errors of its edges, without queries.
bool VertexRemoval::is_candidate(int vertex) const {
    const int h = half_edge_of_[static_cast<std::size_t>(vertex)];
    if (h < 0 || vertex < first_vertex_) {
        return false;
    }
    const auto flat = [&](int spoke) {
        return !(sizing_.tolerance > 0.0) ||
               measure_.distance_known(spoke) <= OptimisationTuning::kRemovalFlat * sizing_.tolerance;
    };
    if (on_edge(vertex)) {
        const std::vector<int> star = work_.mesh.star(h);
        return std::all_of(star.begin(), star.end(), flat);
    }
    int spokes = 0;
    for (int g = h; flat(g);) {
        g = work_.mesh.twin(ClassifiedMesh::prev(g));
        if (++spokes > most_spokes_ || g == h) {
            return g == h && spokes <= most_spokes_;
        }
    }
    return false;
}

bool VertexRemoval::can_be_joined(int near, int far) const {
    const int a = work_.mesh.segment(near).vertices[0];
    const int b = work_.mesh.segment(far).vertices[1];
    return a != b && !work_.maxmin.joined(a, b);
}

std::optional<VertexRemoval::RemovalPlan> VertexRemoval::plan_for(int vertex) const {
    const ClassifiedMesh& mesh = work_.mesh;
    if (!is_candidate(vertex)) {
        return std::nullopt;
    }
    RemovalPlan plan;
    plan.vertex = vertex;
    if (!on_edge(vertex)) {
        return add_fan(half_edge_of_[static_cast<std::size_t>(vertex)], plan) ? std::optional(std::move(plan))
                                                                              : std::nullopt;
    }
    const auto& [near, far] = segments_at_[static_cast<std::size_t>(vertex)];
    if (near < 0 || far < 0 || sizing_.turn > 0.0 || mesh.segment(near).uses.size() != mesh.segment(far).uses.size()) {
        return std::nullopt;
    }
    plan.near = near;
    plan.far = far;
    if (!can_be_joined(near, far)) {
        return std::nullopt;
    }
    for (const ClassifiedMesh::SegmentUse& use : mesh.segment(near).uses) {
        if (!add_fan(mesh.leaving(use, vertex), plan)) {
            return std::nullopt;
        }
    }
    return plan;
}

// Where the present angles are below the bound, new ones need only be larger, but must not be needles. Input angles of
// the shape do not count: a triangle that fills such a corner evenly would be replaced by one that does not.
double VertexRemoval::least_angle(const RemovalCavity& cavity) const {
    double least = least_angle_;
    for (const int t : cavity.triangles) {
        const Exemption* exemption = work_.exemption_of(t);
        if (exemption != nullptr && exemption->cause != Cause::NarrowCorner) {
            least = std::min(least, std::max(OptimisationTuning::kRemovalGain * smallest_angle(work_.mesh, t).angle,
                                             OptimisationTuning::kNoNeedle * bound_));
        }
    }
    return least;
}

bool VertexRemoval::add_fan(int half_edge, RemovalPlan& plan) const {
    const ClassifiedMesh& mesh = work_.mesh;
    auto cavity = removal_cavity(mesh, half_edge);
    if (!cavity || cavity->sides.size() < (cavity->base[0] < 0 ? 4U : 3U)) {
        return false;
    }
    std::vector<Fan> fans = fans_of(mesh, *cavity, least_angle(*cavity));
    const auto good = std::find_if(fans.begin(), fans.end(), [&](const Fan& fan) {
        return heights_expected(*cavity, fan) && lengths_allowed(half_edge, *cavity, fan) &&
               fan_aligned(mesh, *cavity, fan, kWellAligned) && fan_legal(mesh, work_.maxmin, *cavity, fan.apex_site);
    });
    if (good == fans.end()) {
        return false;
    }
    for (const int t : cavity->triangles) {
        plan.stamps.push_back(mesh.stamp(t));
    }
    plan.cavities.push_back(std::move(*cavity));
    plan.fans.push_back(std::move(*good));
    return true;
}

bool VertexRemoval::lengths_allowed(int half_edge, const RemovalCavity& cavity, const Fan& fan) const {
    const ClassifiedMesh& mesh = work_.mesh;
    double longest = 1e300;
    for (const int spoke : mesh.star(half_edge)) {
        longest =
            std::min({longest, sizing_.bounds.of(mesh, spoke), sizing_.bounds.of(mesh, ClassifiedMesh::next(spoke))});
    }
    const auto fits = [&](int from, int to) {
        const ClassifiedMesh::VertexUse& a = mesh.site(from);
        const ClassifiedMesh::VertexUse& b = mesh.site(to);
        return (a.point - b.point).norm() <= longest &&
               (!(sizing_.turn > 0.0) || angle_between(a.normal, b.normal) <= sizing_.turn);
    };
    const std::vector<int> ends = spokes_of(cavity, fan.apex_site);
    return (cavity.base[0] < 0 || fits(cavity.base[0], cavity.base[1])) &&
           std::all_of(ends.begin(), ends.end(), [&](int end) { return fits(fan.apex_site, end); });
}

bool VertexRemoval::heights_expected(const RemovalCavity& cavity, const Fan& fan) const {
    if (!(sizing_.tolerance > 0.0)) {
        return true;
    }
    const std::vector<int> ends = spokes_of(cavity, fan.apex_site);
    return std::all_of(ends.begin(), ends.end(), [&](int end) {
        return edge_peak(work_.mesh.site(fan.apex_site), work_.mesh.site(end)).height <= sizing_.tolerance;
    });
}

// Makes the plans of some candidates in several threads: none of them changes the mesh.
std::vector<std::optional<VertexRemoval::RemovalPlan>> VertexRemoval::plans_for(const int* first,
                                                                                const int* last) const {
    // Candidates that are worth a thread: about half a millisecond.
    constexpr int kWorthAThread = 512;
    std::vector<std::optional<RemovalPlan>> result(static_cast<std::size_t>(last - first));
    for_chunks(static_cast<int>(result.size()), kWorthAThread,
               [&](int k) { result[static_cast<std::size_t>(k)] = plan_for(first[k]); });
    return result;
}

// Removes vertices whose triangles have no other in common, where the tolerance is kept. Candidates whose triangles
// others took are left for later rounds, together with the vertices around what changed.
// @return whether any was removed
bool VertexRemoval::remove_some(std::vector<int>& candidates) {
    // Plans that are made at a time, about a MB.
    constexpr std::size_t kPlansAtOnce = 4096;
    // New triangles take the indices of old ones, so that these stay taken.
    LargeVector<char> taken(static_cast<std::size_t>(work_.mesh.triangle_count()), 0);
    bool changed = false;
    std::vector<int> later;
    for (std::size_t from = 0; from < candidates.size(); from += kPlansAtOnce) {
        work_.progress.check();
        const std::size_t to = std::min(from + kPlansAtOnce, candidates.size());
        std::vector<RemovalPlan> chosen;
        for (std::optional<RemovalPlan>& plan : plans_for(candidates.data() + from, candidates.data() + to)) {
            if (plan) {
                choose(std::move(*plan), taken, chosen, later);
            }
        }
        const std::vector<char> good = within_tolerance(chosen);
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (good[i] && is_valid(chosen[i])) {
                apply(chosen[i], later);
                changed = true;
            }
        }
    }
    candidates = std::move(later);
    return changed;
}

// Adds a plan to the chosen ones and takes its triangles, or leaves its vertex for later where others took them.
void VertexRemoval::choose(RemovalPlan plan, LargeVector<char>& taken, std::vector<RemovalPlan>& chosen,
                           std::vector<int>& later) {
    std::vector<int> triangles;
    for (const RemovalCavity& cavity : plan.cavities) {
        triangles.insert(triangles.end(), cavity.triangles.begin(), cavity.triangles.end());
    }
    std::sort(triangles.begin(), triangles.end());
    if (std::adjacent_find(triangles.begin(), triangles.end()) != triangles.end()) {
        return;  // both sides of a seam use the same triangle
    }
    if (std::any_of(triangles.begin(), triangles.end(), [&](int t) { return taken[static_cast<std::size_t>(t)]; })) {
        later.push_back(plan.vertex);
        return;
    }
    for (const int t : triangles) {
        taken[static_cast<std::size_t>(t)] = 1;
    }
    chosen.push_back(std::move(plan));
}

// Adds queries for the joined segment, and for inner edges and triangles of the fans.
void VertexRemoval::add_new(const RemovalPlan& plan, geometry::Engine::Batch& batch) const {
    const ClassifiedMesh& mesh = work_.mesh;
    for (std::size_t k = 0; k < plan.cavities.size(); ++k) {
        const int face = mesh.face_of(plan.cavities[k].triangles.front());
        const int apex = plan.fans[k].apex_site;
        for (const int end : spokes_of(plan.cavities[k], apex)) {
            add_edge_probes(work_, face, mesh.site(apex), mesh.site(end), batch);
        }
        for (const auto& t : plan.fans[k].triangles) {
            add_triangle_probe(work_, face, mesh.site(t[0]), mesh.site(t[1]), mesh.site(t[2]), batch);
        }
    }
    if (plan.near >= 0) {
        const ClassifiedMesh::Segment& near = mesh.segment(plan.near);
        const ClassifiedMesh::Segment& far = mesh.segment(plan.far);
        add_segment_probes(work_, near.edge, {mesh.vertex(near.vertices[0]).point, near.t[0]},
                           {mesh.vertex(far.vertices[1]).point, far.t[1]}, batch);
    }
}

// Adds queries for the present edges at the vertex, if there is no tolerance.
void VertexRemoval::add_old(const RemovalPlan& plan, geometry::Engine::Batch& batch) const {
    const ClassifiedMesh& mesh = work_.mesh;
    for (const RemovalCavity& cavity : plan.cavities) {
        for (const int t : sizing_.tolerance > 0.0 ? std::vector<int>() : cavity.triangles) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                if (mesh.vertex_of(h) == plan.vertex) {
                    add_edge_probe(work_, mesh.face_of(t), mesh.site(mesh.site_of(h)),
                                   mesh.site(mesh.site_of(ClassifiedMesh::next(h))), 0.5, batch);
                }
            }
        }
    }
}

// Returns the backward distance to the joined segment and to the triangles of the fans, mm.
double VertexRemoval::backward_to_new(const RemovalPlan& plan) const {
    const ClassifiedMesh& mesh = work_.mesh;
    double farthest = 0.0;
    for (std::size_t k = 0; k < plan.cavities.size(); ++k) {
        const int face = mesh.face_of(plan.cavities[k].triangles.front());
        for (const auto& t : plan.fans[k].triangles) {
            farthest =
                std::max(farthest, backward_distance(work_, face, mesh.site(t[0]), mesh.site(t[1]), mesh.site(t[2])));
        }
    }
    if (plan.near >= 0) {
        const ClassifiedMesh::Segment& near = mesh.segment(plan.near);
        const ClassifiedMesh::Segment& far = mesh.segment(plan.far);
        const BackwardDistance back =
            backward_distance(work_, near.edge, {mesh.vertex(near.vertices[0]).point, near.t[0]},
                              {mesh.vertex(far.vertices[1]).point, far.t[1]});
        farthest = std::max(farthest, back.distance);
    }
    return farthest;
}

// Returns the distance that new pieces of a plan may have, mm, if the queries about them keep it.
std::optional<double> VertexRemoval::distance_kept(geometry::Answerer& answerer, const RemovalPlan& plan) const {
    geometry::Engine::Batch batch;
    add_old(plan, batch);
    const auto new_from = static_cast<std::ptrdiff_t>(batch.size());
    add_new(plan, batch);
    double allowed = std::max(kNear * sizing_.tolerance, kExact * work_.grid.resolution());
    std::for_each(batch.begin(), batch.begin() + new_from, [&](const geometry::Query& query) {
        const geometry::Answer answer = answerer.answer(query);
        allowed = answer.found() ? std::max(allowed, answer.distance) : allowed;
    });
    const bool kept = std::all_of(batch.begin() + new_from, batch.end(), [&](const geometry::Query& query) {
        const geometry::Answer answer = answerer.answer(query);
        return answer.found() && answer.distance <= allowed;
    });
    return kept ? std::optional(allowed) : std::nullopt;
}

// Computes the sample points that the backward distance to a plan needs.
void VertexRemoval::compute_samples(const RemovalPlan& plan) {
    for (const RemovalCavity& cavity : plan.cavities) {
        work_.span_points.compute_on_face(work_.mesh.face_of(cavity.triangles.front()));
    }
    if (plan.near >= 0) {
        work_.span_points.compute_on_edge(work_.mesh.segment(plan.near).edge);
    }
}

// By plan: whether everything new in it keeps the tolerance.
std::vector<char> VertexRemoval::within_tolerance(const std::vector<RemovalPlan>& plans) {
    std::vector<std::optional<double>> kept(plans.size());
    work_.session.for_chunks(plans.size(), [&](geometry::Answerer& answerer, std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            kept[i] = distance_kept(answerer, plans[i]);
        }
    });
    for (std::size_t i = 0; sizing_.tolerance > 0.0 && i < plans.size(); ++i) {
        if (kept[i]) {
            compute_samples(plans[i]);
        }
    }
    std::vector<char> good(plans.size(), 0);
    for_chunks(static_cast<int>(plans.size()), [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        good[i] = kept[i] && (!(sizing_.tolerance > 0.0) || backward_to_new(plans[i]) <= *kept[i]) ? 1 : 0;
    });
    return good;
}

// A neighbouring removal may have created one of its edges.
bool VertexRemoval::is_valid(const RemovalPlan& plan) const {
    if (plan.near >= 0 && !can_be_joined(plan.near, plan.far)) {
        return false;
    }
    std::size_t i = 0;
    for (const RemovalCavity& cavity : plan.cavities) {
        for (const int t : cavity.triangles) {
            if (work_.mesh.gone(t) || work_.mesh.stamp(t) != plan.stamps[i++]) {
                return false;
            }
        }
    }
    for (std::size_t k = 0; k < plan.cavities.size(); ++k) {
        if (!fan_legal(work_.mesh, work_.maxmin, plan.cavities[k], plan.fans[k].apex_site)) {
            return false;
        }
    }
    return true;
}

// @param around  receives the vertices of the changed triangles.
void VertexRemoval::apply(const RemovalPlan& plan, std::vector<int>& around) {
    std::vector<ClassifiedMesh::CavityFill> refills;
    std::vector<int> removed;
    for (std::size_t k = 0; k < plan.cavities.size(); ++k) {
        const std::vector<int>& triangles = plan.cavities[k].triangles;
        refills.push_back({triangles, plan.fans[k].triangles, plan.cavities[k].base});
        removed.insert(removed.end(), triangles.begin(), triangles.end());
    }
    const std::optional<Exemption> reason = withdraw_exemptions(work_, removed);
    half_edge_of_[static_cast<std::size_t>(plan.vertex)] = -1;
    std::vector<int> added;
    if (plan.near < 0) {
        added = work_.maxmin.replace(refills[0].removed, refills[0].added);
    } else {
        added = work_.maxmin.join_segments(plan.near, plan.far, refills);
        segments_at_[static_cast<std::size_t>(work_.mesh.segment(plan.near).vertices[1])][0] = plan.near;
    }
    restore_exemptions(work_, added, bound_, reason);
    for (const int t : added) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            half_edge_of_[static_cast<std::size_t>(work_.mesh.vertex_of(h))] = h;
            around.push_back(work_.mesh.vertex_of(h));
        }
    }
}

// Returns the vertices that may go: those of each CAD edge from its one end to the other, then those inside faces, the
// last first. Neighbours on an edge share triangles, so that a round takes every other vertex; across a strip the next
// round takes those between, which leaves the longest pieces that the bound allows.
std::vector<int> VertexRemoval::in_order() const {
    struct Place {
        int edge;
        double t;
        int vertex;
        bool operator<(const Place& other) const {
            return std::tie(edge, t, vertex) < std::tie(other.edge, other.t, other.vertex);
        }
    };
    std::vector<Place> on_edges;
    std::vector<int> inside;
    for (int v = work_.mesh.vertex_count() - 1; v >= first_vertex_; --v) {
        const int far = on_edge(v) ? segments_at_[static_cast<std::size_t>(v)][1] : -1;
        if (far >= 0) {
            on_edges.push_back({work_.mesh.segment(far).edge, work_.mesh.segment(far).t[0], v});
        } else {
            inside.push_back(v);
        }
    }
    std::sort(on_edges.begin(), on_edges.end());
    std::vector<int> order;
    order.reserve(on_edges.size() + inside.size());
    for (const Place& place : on_edges) {
        order.push_back(place.vertex);
    }
    order.insert(order.end(), inside.begin(), inside.end());
    return order;
}

bool VertexRemoval::run() {
    if (sizing_.growth > 0.0) {
        return false;  // longer edges would have to satisfy the growth bounds of all neighbours
    }
    find_places();
    std::vector<int> candidates = in_order();
    std::vector<int> rank(static_cast<std::size_t>(work_.mesh.vertex_count()), -1);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        rank[static_cast<std::size_t>(candidates[i])] = static_cast<int>(i);
    }
    const auto by_rank = [&](int a, int b) {
        return rank[static_cast<std::size_t>(a)] < rank[static_cast<std::size_t>(b)];
    };
    bool changed = false;
    for (int round = 0; round < OptimisationTuning::kMaxRemovalRounds && !candidates.empty(); ++round) {
        work_.progress.check();
        changed = remove_some(candidates) || changed;
        candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                        [&](int v) { return rank[static_cast<std::size_t>(v)] < 0; }),
                         candidates.end());
        std::sort(candidates.begin(), candidates.end(), by_rank);
        candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    }
    close_gaps(work_);
    return changed;
}

}  // namespace mq::triangulate
