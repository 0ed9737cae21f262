// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/coarsener.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.h"
#include "triangulate/corner_angle.h"
#include "triangulate/deviation.h"
#include "triangulate/disc_change.h"
#include "triangulate/distance_probes.h"
#include "triangulate/segments_at.h"
#include "triangulate/way_back.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

// New angles are a little above the bound, so that what comes later has room.
constexpr double kMargin = 1.04;
// Of the tolerance. A vertex is kept where an edge at it is higher than the first: edges become about twice as long
// without it, and four times as high.
constexpr double kFlat = 0.6;
constexpr double kExact = 2.0;  // in steps of single precision: flat places are off by so much
constexpr int kMaxRounds = 12;
constexpr double kGain = 1.1;      // of angles below the bound
constexpr double kNoNeedle = 0.1;  // of the bound

}  // namespace

Coarsener::Coarsener(Workspace& work, const ChordMeasure& measure, double min_angle_degrees, const Sizing& sizing,
                     int first_vertex)
    : work_(work),
      measure_(measure),
      bound_(min_angle_degrees * kDegree),
      least_angle_(kMargin * bound_),
      sizing_(sizing),
      first_vertex_(first_vertex),
      most_spokes_(static_cast<int>(M_PI / least_angle_)) {}

void Coarsener::find_places() {
    const SurfaceMesh& mesh = work_.mesh;
    half_edge_of_.assign(static_cast<std::size_t>(mesh.vertex_count()), -1);
    segments_at_ = segments_at_vertices(mesh);
    for (int h = mesh.half_edge_count() - 1; h >= 0; --h) {
        half_edge_of_[static_cast<std::size_t>(mesh.vertex_of(h))] = h;
    }
}

// By what is known of the edges at it, without a question.
bool Coarsener::worth_trying(int vertex) const {
    const int h = half_edge_of_[static_cast<std::size_t>(vertex)];
    if (h < 0 || vertex < first_vertex_) {
        return false;
    }
    const auto flat = [&](int spoke) {
        return !(sizing_.tolerance > 0.0) || measure_.distance_known(spoke) <= kFlat * sizing_.tolerance;
    };
    if (on_edge(vertex)) {
        const std::vector<int> star = work_.mesh.star(h);
        return std::all_of(star.begin(), star.end(), flat);
    }
    int spokes = 0;
    for (int g = h; flat(g);) {
        g = work_.mesh.twin(SurfaceMesh::prev(g));
        if (++spokes > most_spokes_ || g == h) {
            return g == h && spokes <= most_spokes_;
        }
    }
    return false;
}

bool Coarsener::can_be_joined(int near, int far) const {
    const int a = work_.mesh.segment(near).vertices[0];
    const int b = work_.mesh.segment(far).vertices[1];
    return a != b && !work_.maxmin.joined(a, b);
}

std::optional<Coarsener::Plan> Coarsener::plan_for(int vertex) const {
    const SurfaceMesh& mesh = work_.mesh;
    if (!worth_trying(vertex)) {
        return std::nullopt;
    }
    Plan plan;
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
    for (const SurfaceMesh::SegmentUse& use : mesh.segment(near).uses) {
        if (!add_fan(mesh.leaving(use, vertex), plan)) {
            return std::nullopt;
        }
    }
    return plan;
}

// Where there are smaller angles than the bound now, more than these will do, but no needle takes the place of another.
// Angles of the part itself do not count: a triangle that fills its corner evenly would give way to one that does not.
double Coarsener::least_angle(const StarPolygon& polygon) const {
    double least = least_angle_;
    for (const int t : polygon.triangles) {
        const Exemption* exemption = work_.exemption_of(t);
        if (exemption != nullptr && exemption->cause != Cause::NarrowCorner) {
            least = std::min(least, std::max(kGain * smallest_angle(work_.mesh, t).angle, kNoNeedle * bound_));
        }
    }
    return least;
}

bool Coarsener::add_fan(int half_edge, Plan& plan) const {
    const SurfaceMesh& mesh = work_.mesh;
    auto polygon = star_polygon(mesh, half_edge);
    if (!polygon || polygon->sides.size() < 4) {
        return false;
    }
    std::vector<PolygonFan> fans = fans_of(mesh, *polygon, least_angle(*polygon));
    const auto good = std::find_if(fans.begin(), fans.end(), [&](const PolygonFan& fan) {
        return heights_expected(*polygon, fan) && lengths_allowed(half_edge, *polygon, fan) &&
               fan_aligned(mesh, *polygon, fan, kWellAligned) && fan_legal(mesh, work_.maxmin, *polygon, fan.apex_site);
    });
    if (good == fans.end()) {
        return false;
    }
    for (const int t : polygon->triangles) {
        plan.stamps.push_back(mesh.stamp(t));
    }
    plan.polygons.push_back(std::move(*polygon));
    plan.fans.push_back(std::move(*good));
    return true;
}

bool Coarsener::lengths_allowed(int half_edge, const StarPolygon& polygon, const PolygonFan& fan) const {
    const SurfaceMesh& mesh = work_.mesh;
    double longest = 1e300;
    for (const int spoke : mesh.star(half_edge)) {
        longest =
            std::min({longest, sizing_.bounds.of(mesh, spoke), sizing_.bounds.of(mesh, SurfaceMesh::next(spoke))});
    }
    const auto fits = [&](int from, int to) {
        const SurfaceMesh::Site& a = mesh.site(from);
        const SurfaceMesh::Site& b = mesh.site(to);
        return (a.point - b.point).norm() <= longest &&
               (!(sizing_.turn > 0.0) || angle_between(a.normal, b.normal) <= sizing_.turn);
    };
    const std::vector<int> ends = spokes_of(polygon, fan.apex_site);
    return (polygon.base[0] < 0 || fits(polygon.base[0], polygon.base[1])) &&
           std::all_of(ends.begin(), ends.end(), [&](int end) { return fits(fan.apex_site, end); });
}

bool Coarsener::heights_expected(const StarPolygon& polygon, const PolygonFan& fan) const {
    if (!(sizing_.tolerance > 0.0)) {
        return true;
    }
    const std::vector<int> ends = spokes_of(polygon, fan.apex_site);
    return std::all_of(ends.begin(), ends.end(), [&](int end) {
        return edge_peak(work_.mesh.site(fan.apex_site), work_.mesh.site(end)).height <= sizing_.tolerance;
    });
}

// Those that do not touch each other; the candidates that remain are for later rounds.
std::vector<Coarsener::Plan> Coarsener::plans(std::vector<int>& candidates) {
    std::vector<char> taken(static_cast<std::size_t>(work_.mesh.triangle_count()), 0);
    std::vector<Plan> result;
    std::vector<int> later;
    Pace pace(work_.progress);
    for (const int v : candidates) {
        pace.step();
        auto plan = plan_for(v);
        if (!plan) {
            continue;
        }
        std::vector<int> triangles;
        for (const StarPolygon& polygon : plan->polygons) {
            triangles.insert(triangles.end(), polygon.triangles.begin(), polygon.triangles.end());
        }
        std::vector<int> sorted = triangles;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
            continue;  // both sides of a seam want the same triangle
        }
        if (std::any_of(triangles.begin(), triangles.end(),
                        [&](int t) { return taken[static_cast<std::size_t>(t)]; })) {
            later.push_back(v);
            continue;
        }
        for (const int t : triangles) {
            taken[static_cast<std::size_t>(t)] = 1;
        }
        result.push_back(std::move(*plan));
    }
    candidates = std::move(later);
    return result;
}

// The joined segment, inner edges and triangles of the fans.
void Coarsener::add_new(const Plan& plan, geometry::Engine::Batch& batch) const {
    const SurfaceMesh& mesh = work_.mesh;
    for (std::size_t k = 0; k < plan.polygons.size(); ++k) {
        const int face = mesh.face_of(plan.polygons[k].triangles.front());
        const int apex = plan.fans[k].apex_site;
        for (const int end : spokes_of(plan.polygons[k], apex)) {
            add_edge_probes(work_, face, mesh.site(apex), mesh.site(end), batch);
        }
        for (const auto& t : plan.fans[k].triangles) {
            add_triangle_probe(work_, face, mesh.site(t[0]), mesh.site(t[1]), mesh.site(t[2]), batch);
        }
    }
    if (plan.near >= 0) {
        const SurfaceMesh::Segment& near = mesh.segment(plan.near);
        const SurfaceMesh::Segment& far = mesh.segment(plan.far);
        add_segment_probes(work_, near.edge, {mesh.vertex(near.vertices[0]).point, near.t[0]},
                           {mesh.vertex(far.vertices[1]).point, far.t[1]}, batch);
    }
}

// Without a tolerance: the edges that there are.
void Coarsener::add_old(const Plan& plan, geometry::Engine::Batch& batch) const {
    const SurfaceMesh& mesh = work_.mesh;
    for (const StarPolygon& polygon : plan.polygons) {
        for (const int t : sizing_.tolerance > 0.0 ? std::vector<int>() : polygon.triangles) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                if (mesh.vertex_of(h) == plan.vertex) {
                    add_edge_probe(work_, mesh.face_of(t), mesh.site(mesh.site_of(h)),
                                   mesh.site(mesh.site_of(SurfaceMesh::next(h))), 0.5, batch);
                }
            }
        }
    }
}

// From the part to the joined segment and to the triangles of the fans, mm.
double Coarsener::way_back_to_new(const Plan& plan) const {
    const SurfaceMesh& mesh = work_.mesh;
    double farthest = 0.0;
    for (std::size_t k = 0; k < plan.polygons.size(); ++k) {
        const int face = mesh.face_of(plan.polygons[k].triangles.front());
        for (const auto& t : plan.fans[k].triangles) {
            farthest = std::max(farthest, way_back(work_, face, mesh.site(t[0]), mesh.site(t[1]), mesh.site(t[2])));
        }
    }
    if (plan.near >= 0) {
        const SurfaceMesh::Segment& near = mesh.segment(plan.near);
        const SurfaceMesh::Segment& far = mesh.segment(plan.far);
        const WayBack back = way_back(work_, near.edge, {mesh.vertex(near.vertices[0]).point, near.t[0]},
                                      {mesh.vertex(far.vertices[1]).point, far.t[1]});
        farthest = std::max(farthest, back.distance);
    }
    return farthest;
}

// By plan: whether all that is new in it keeps the tolerance.
std::vector<char> Coarsener::near_part(const std::vector<Plan>& plans) {
    geometry::Engine::Batch batch;
    std::vector<std::array<std::size_t, 3>> parts;  // of the batch, by plan: of its old pieces, from there of new ones
    for (const Plan& plan : plans) {
        const std::size_t old_from = batch.size();
        add_old(plan, batch);
        const std::size_t new_from = batch.size();
        add_new(plan, batch);
        parts.push_back({old_from, new_from, batch.size()});
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(batch));
    std::vector<char> good(plans.size(), 1);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        double allowed = std::max(kNear * sizing_.tolerance, kExact * work_.grid.resolution());
        for (std::size_t k = parts[i][0]; k < parts[i][1]; ++k) {
            allowed = answers[k].found() ? std::max(allowed, answers[k].distance) : allowed;
        }
        for (std::size_t k = parts[i][1]; k < parts[i][2]; ++k) {
            good[i] = good[i] != 0 && answers[k].found() && answers[k].distance <= allowed ? 1 : 0;
        }
        if (sizing_.tolerance > 0.0 && good[i] != 0 && way_back_to_new(plans[i]) > allowed) {
            good[i] = 0;
        }
    }
    return good;
}

// What was done beside it may have made one of its edges.
bool Coarsener::still_good(const Plan& plan) const {
    if (plan.near >= 0 && !can_be_joined(plan.near, plan.far)) {
        return false;
    }
    std::size_t i = 0;
    for (const StarPolygon& polygon : plan.polygons) {
        for (const int t : polygon.triangles) {
            if (work_.mesh.gone(t) || work_.mesh.stamp(t) != plan.stamps[i++]) {
                return false;
            }
        }
    }
    for (std::size_t k = 0; k < plan.polygons.size(); ++k) {
        if (!fan_legal(work_.mesh, work_.maxmin, plan.polygons[k], plan.fans[k].apex_site)) {
            return false;
        }
    }
    return true;
}

// @param around takes the vertices that the changed triangles have.
void Coarsener::carry_out(const Plan& plan, std::vector<int>& around) {
    std::vector<SurfaceMesh::Refill> refills;
    std::vector<int> removed;
    for (std::size_t k = 0; k < plan.polygons.size(); ++k) {
        const std::vector<int>& triangles = plan.polygons[k].triangles;
        refills.push_back({triangles, plan.fans[k].triangles, plan.polygons[k].base});
        removed.insert(removed.end(), triangles.begin(), triangles.end());
    }
    const std::optional<Exemption> reason = take_exemptions(work_, removed);
    half_edge_of_[static_cast<std::size_t>(plan.vertex)] = -1;
    std::vector<int> added;
    if (plan.near < 0) {
        added = work_.maxmin.replace(refills[0].removed, refills[0].added);
    } else {
        added = work_.maxmin.join_segments(plan.near, plan.far, refills);
        segments_at_[static_cast<std::size_t>(work_.mesh.segment(plan.near).vertices[1])][0] = plan.near;
    }
    exempt_bad(work_, added, bound_, reason);
    for (const int t : added) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            half_edge_of_[static_cast<std::size_t>(work_.mesh.vertex_of(h))] = h;
            around.push_back(work_.mesh.vertex_of(h));
        }
    }
}

bool Coarsener::run() {
    if (sizing_.growth > 0.0) {
        return false;  // longer edges would have to be weighed against all around
    }
    find_places();
    std::vector<int> candidates;
    for (int v = work_.mesh.vertex_count() - 1; v >= first_vertex_; --v) {
        candidates.push_back(v);
    }
    bool changed = false;
    for (int round = 0; round < kMaxRounds && !candidates.empty(); ++round) {
        work_.progress.check();
        const std::vector<Plan> found = plans(candidates);
        const std::vector<char> good = near_part(found);
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (good[i] && still_good(found[i])) {
                carry_out(found[i], candidates);
                changed = true;
            }
        }
        std::sort(candidates.begin(), candidates.end(), std::greater<>());
        candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    }
    close_gaps(work_);
    return changed;
}

}  // namespace mq::triangulate
