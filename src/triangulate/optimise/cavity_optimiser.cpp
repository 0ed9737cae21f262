// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/optimise/cavity_optimiser.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/angle.h"
#include "triangulate/measure/backward_distance.h"
#include "triangulate/measure/distance_probes.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/operators/fan_feasibility.h"
#include "triangulate/optimise/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

using geometry::Query;

void add_disc(const ClassifiedMesh& mesh, std::vector<int> triangles, std::vector<Cavity>& discs) {
    if (triangles.empty() || triangles.size() > OptimisationTuning::kMaxDisc) {
        return;
    }
    if (auto disc = disc_of(mesh, std::move(triangles))) {
        discs.push_back(std::move(*disc));
    }
}

}  // namespace

CavityOptimiser::CavityOptimiser(Workspace& work, double min_angle_degrees, const Sizing& sizing, std::size_t attempts)
    : work_(work),
      bound_(min_angle_degrees * kDegree),
      sizing_(sizing),
      slider_(work, sizing),
      undo_(work),
      attempts_of_all_(attempts) {
    want(bound_ + OptimisationTuning::kTargetMargin);
}

// Whether the shape itself has the angle, or an earlier run could not improve the triangle.
bool CavityOptimiser::hopeless(int triangle) const {
    const Exemption* exemption = work_.exemption_of(triangle);
    return exemption != nullptr && (exemption->cause == Cause::NarrowCorner || exemption->cause == Cause::Apex ||
                                    work_.settled.marked(work_.mesh, triangle));
}

double CavityOptimiser::enough_after(double before) const {
    return before + OptimisationTuning::kLeastGain +
           OptimisationTuning::kGainOfDeficit * std::max(0.0, wanted_ - before);
}

// Whether the triangle lies at a tip as small as the resolution, which is tried only once in a pass.
bool CavityOptimiser::at_resolution(int triangle) const {
    const Exemption* exemption = work_.exemption_of(triangle);
    return exemption != nullptr &&
           (exemption->cause == Cause::Resolution || exemption->cause == Cause::FaceFloorRaised);
}

void CavityOptimiser::want(double angle) {
    found_.clear();
    wanted_ = angle;
    surely_enough_ = sine_squared_above(angle);
}

void CavityOptimiser::push_if_bad(int triangle) {
    if (squared_sine_of_smallest_angle(work_.mesh, triangle) > surely_enough_) {
        return;
    }
    const double angle = smallest_angle(work_.mesh, triangle).angle;
    if (angle < wanted_ && !hopeless(triangle) && (angle < bound_ || near(triangle))) {
        queue_.push({angle, triangle, work_.mesh.stamp(triangle)});
    }
}

bool CavityOptimiser::near(int triangle) const {
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (std::binary_search(near_.begin(), near_.end(), work_.mesh.vertex_of(h))) {
            return true;
        }
    }
    return false;
}

void CavityOptimiser::push_all() {
    queue_ = {};
    for (int t = 0; t < work_.mesh.triangle_count(); ++t) {
        if (!work_.mesh.gone(t)) {
            if (at_resolution(t)) {
                failed_.unmark(t);
                failed_beyond_.unmark(t);
            }
            push_if_bad(t);
        }
    }
}

bool CavityOptimiser::improve_once() {
    push_all();
    return process_queue();
}

bool CavityOptimiser::over_improve_neighbours_and_retry() {
    over_improve_neighbours();
    return improve_once();
}

bool CavityOptimiser::search() {
    bool changed = false;
    double left = missing();
    while (left > 0.0) {
        changed = over_improve_neighbours_and_retry() || changed;
        changed = perturb_all() || changed;
        const double now = missing();
        if (now > OptimisationTuning::kLeftAfterRound * left) {
            break;
        }
        left = now;
    }
    return changed;
}

double CavityOptimiser::missing() const {
    double sum = 0.0;
    for (const auto& [triangle, exemption] : work_.exempt) {
        if (work_.exemption_of(triangle) != nullptr && !hopeless(triangle)) {
            sum += std::max(0.0, bound_ - smallest_angle(work_.mesh, triangle).angle);
        }
    }
    return sum;
}

// Processes the queue, including triangles that are added meanwhile.
bool CavityOptimiser::process_queue() {
    bool changed = false;
    std::size_t left = std::min(OptimisationTuning::kAttemptsEach * queue_.size(),
                                OptimisationTuning::kAttempts + static_cast<std::size_t>(work_.mesh.triangle_count()) /
                                                                    OptimisationTuning::kTrianglesPerAttempt);
    while (process_next(left, changed)) {
    }
    return changed;
}

// @return whether there may be more to do.
bool CavityOptimiser::process_next(std::size_t& left, bool& changed) {
    work_.progress.check();
    if (queue_.empty() || left == 0 || attempts_of_all_ == 0 || work_.over_budget()) {
        return false;
    }
    const QueuedTriangle bad = queue_.top();
    queue_.pop();
    if (work_.mesh.stamp(bad.triangle) != bad.stamp || has_failed(bad.triangle)) {
        return true;
    }
    --left;
    --attempts_of_all_;
    if (mend(bad.triangle)) {
        changed = true;
    } else {
        (near_.empty() ? failed_ : failed_beyond_).mark(work_.mesh, bad.triangle);
    }
    return true;
}

// A triangle that cannot reach the bound cannot reach the larger target either.
bool CavityOptimiser::has_failed(int triangle) const {
    return failed_.marked(work_.mesh, triangle) || (!near_.empty() && failed_beyond_.marked(work_.mesh, triangle));
}

std::vector<int> CavityOptimiser::bad_triangles() const {
    std::vector<int> bad;
    for (const auto& [triangle, exemption] : work_.exempt) {
        if (work_.exemption_of(triangle) != nullptr && !hopeless(triangle) && !at_resolution(triangle) &&
            smallest_angle(work_.mesh, triangle).angle < bound_) {
            bad.push_back(triangle);
        }
    }
    return bad;
}

// Good triangles beside bad ones prevent changes if their angles are just above the bound; this improves them further.
void CavityOptimiser::over_improve_neighbours() {
    std::set<int> vertices;
    std::set<int> visited;  // sites: each bad triangle of a fan would visit the whole fan around its apex
    for (const int t : bad_triangles()) {
        work_.progress.check();
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            if (!visited.insert(work_.mesh.site_of(h)).second) {
                continue;
            }
            for (const int other : triangles_around(work_.mesh, h)) {
                for (int k = 3 * other; k < 3 * other + 3; ++k) {
                    vertices.insert(work_.mesh.vertex_of(k));
                }
            }
        }
    }
    if (vertices.empty()) {
        return;
    }
    near_.assign(vertices.begin(), vertices.end());
    want(bound_ + OptimisationTuning::kRoomBesideBad);
    push_all();
    process_queue();
    want(bound_ + OptimisationTuning::kTargetMargin);
    near_.clear();
}

std::vector<Cavity> CavityOptimiser::discs_around(int triangle) const {
    const ClassifiedMesh& mesh = work_.mesh;
    std::vector<Cavity> discs;
    std::vector<int> with_neighbours{triangle};
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        add_disc(mesh, triangles_around(mesh, h, OptimisationTuning::kMaxDisc), discs);
        const int g = mesh.twin(h);
        if (g < 0) {
            continue;
        }
        with_neighbours.push_back(ClassifiedMesh::triangle_of(g));
        add_disc(mesh, {triangle, ClassifiedMesh::triangle_of(g)}, discs);
        std::vector<int> both = triangles_around(mesh, h, OptimisationTuning::kMaxDisc);
        const std::vector<int> other = triangles_around(mesh, ClassifiedMesh::next(h), OptimisationTuning::kMaxDisc);
        if (!both.empty() && !other.empty()) {
            both.insert(both.end(), other.begin(), other.end());
            add_disc(mesh, std::move(both), discs);
        }
    }
    add_disc(mesh, std::move(with_neighbours), discs);
    return discs;
}

// Most cavities occur again, beside another bad triangle or in another trial.
const CavityOptimiser::CavityCandidates& CavityOptimiser::fans_of(const Cavity& disc) {
    if (found_.size() > OptimisationTuning::kMaxCached) {
        found_.clear();
    }
    const auto [place, fresh] = found_.try_emplace(state_key(work_.mesh, disc.triangles));
    if (fresh) {
        place.value() = search_fans(disc);
    }
    return place->second;
}

CavityOptimiser::CavityCandidates CavityOptimiser::search_fans(const Cavity& disc) const {
    CavityCandidates found;
    found.before = smallest_angle(work_.mesh, disc);
    const double enough = enough_after(found.before);
    const auto keep = [&](int apex_site, const Vec3& apex, double angle) {
        if (angle >= enough) {
            found.fans.push_back({apex_site, apex, angle});
        }
    };
    const FanFeasibility feasible(work_.mesh, disc, enough);
    for (std::size_t k = 0; k < disc.rim.size(); ++k) {
        if (feasible.allow_apex(k)) {
            const int site = work_.mesh.site_of(disc.rim[k]);
            const Vec3& apex = work_.mesh.point_of(disc.rim[k]);
            keep(site, apex, fan_angle(work_.mesh, disc, apex, site, enough));
        }
    }
    const Vec3 apex = feasible.allow_inner_apex() ? best_apex(work_.mesh, disc) : rough_apex(work_.mesh, disc);
    const double angle = fan_angle(work_.mesh, disc, apex);
    keep(-1, apex, angle);
    if (angle < wanted_) {
        const int blocking = feasible.blocking_side();
        found.over = blocking >= 0 ? disc.rim[static_cast<std::size_t>(blocking)] : worst_side(work_.mesh, disc, apex);
    }
    return found;
}

// @return the worst side, beyond which a larger cavity may give larger angles; -1: none is needed, or there is none.
int CavityOptimiser::propose(const Cavity& disc, std::vector<Retriangulation>& proposals) {
    const CavityCandidates& found = fans_of(disc);
    for (const Fan& fan : found.fans) {
        proposals.push_back({disc, fan.apex_site, fan.apex, fan.angle, found.before});
    }
    return found.over;
}

// Extends each disc by the neighbour across the side with the same index; -1: drops the disc.
std::vector<Cavity> CavityOptimiser::grown(const std::vector<Cavity>& discs, const std::vector<int>& over) const {
    std::vector<Cavity> result;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        const int g = over[i] < 0 ? -1 : work_.mesh.twin(over[i]);
        if (g >= 0) {
            std::vector<int> triangles = discs[i].triangles;
            triangles.push_back(ClassifiedMesh::triangle_of(g));
            add_disc(work_.mesh, std::move(triangles), result);
        }
    }
    return result;
}

// Tries small cavities first, and stops at the first size at which the best fan reaches the target.
bool CavityOptimiser::mend(int triangle) {
    std::vector<Retriangulation> proposals;
    std::vector<Cavity> discs = discs_around(triangle);
    std::vector<std::uint64_t> keys;
    const auto smaller = [](const Cavity& a, const Cavity& b) { return a.triangles.size() < b.triangles.size(); };
    const auto known = [&](const Cavity& disc) {
        keys.push_back(state_key(work_.mesh, disc.triangles));
        return exhausted_.count(keys.back()) > 0;
    };
    discs.erase(std::remove_if(discs.begin(), discs.end(), known), discs.end());
    for (int growth = 0; growth <= OptimisationTuning::kMaxGrowth; ++growth) {
        std::stable_sort(discs.begin(), discs.end(), smaller);
        std::vector<int> worst_sides;
        for (auto disc = discs.begin(); disc != discs.end(); ++disc) {
            worst_sides.push_back(propose(*disc, proposals));
            const bool last_of_size = disc + 1 == discs.end() || smaller(*disc, *(disc + 1));
            if (last_of_size && try_best(proposals, wanted_)) {
                return true;
            }
        }
        if (growth < OptimisationTuning::kMaxGrowth) {
            discs = grown(discs, worst_sides);
        }
    }
    if (slide(triangle) || try_best(proposals, 0.0)) {
        return true;
    }
    if (!undo_.is_open() && near_.empty()) {
        exhausted_.insert(keys.begin(), keys.end());
    }
    return false;
}

// Tries the best proposals, and removes those it tried.
bool CavityOptimiser::try_best(std::vector<Retriangulation>& proposals, double at_least) {
    std::stable_sort(proposals.begin(), proposals.end(), [&](const Retriangulation& a, const Retriangulation& b) {
        const double first = std::min(a.angle, wanted_);
        const double second = std::min(b.angle, wanted_);
        return first != second ? first > second : a.disc.triangles.size() < b.disc.triangles.size();
    });
    std::size_t tried = 0;
    while (tried < proposals.size() && tried < OptimisationTuning::kMaxFans && proposals[tried].angle >= at_least) {
        if (apply(proposals[tried])) {
            return true;
        }
        ++tried;
    }
    proposals.erase(proposals.begin(), proposals.begin() + static_cast<std::ptrdiff_t>(tried));
    return false;
}

bool CavityOptimiser::good_enough(const Cavity& disc, const Corner& apex, int apex_site, double before) const {
    const double least = std::min(least_aligned_, disc_alignment(work_.mesh, disc));
    const double enough = enough_after(before);
    return fan_angle(work_.mesh, disc, apex.point, apex_site, enough) >= enough &&
           fan_alignment(work_.mesh, disc, apex, apex_site) >= least &&
           within_bounds(work_, sizing_, disc, apex, apex_site);
}

// Returns the largest distance of a fan from the surface, at the middles of the spokes and where spokes and triangles
// are expected to be farthest, and the backward distance, mm.
double CavityOptimiser::distance_of_fan(const Cavity& disc, const Corner& apex, const Vec2& uv, int apex_site) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const ClassifiedMesh::VertexUse top{-1, uv, apex.normal, apex.point};
    geometry::Engine::Batch batch;
    double back = 0.0;
    const int face = mesh.face_of(disc.triangles.front());
    for (const int side : disc.rim) {
        const ClassifiedMesh::VertexUse& a = mesh.site(mesh.site_of(side));
        const ClassifiedMesh::VertexUse& b = mesh.site(mesh.site_of(ClassifiedMesh::next(side)));
        add_edge_probes(work_, face, a, top, batch);
        if (mesh.site_of(side) != apex_site && mesh.site_of(ClassifiedMesh::next(side)) != apex_site) {
            add_triangle_probe(work_, face, a, b, top, batch);
            back = std::max(back, backward_distance(work_, face, a, b, top));
        }
    }
    return std::max(back, largest_distance(work_.session.ask(std::move(batch)), 0.0));
}

// Returns the largest distance of the present triangles, at the middles of the inner edges, and the backward distance,
// mm.
double CavityOptimiser::distance_of_disc(const Cavity& disc) const {
    const ClassifiedMesh& mesh = work_.mesh;
    geometry::Engine::Batch batch;
    const auto add = [&](const Candidate& c) {
        batch.push_back(
            Query::face_nearest(mesh.face_of(c.triangle), work_.grid.to_shape(c.point), c.uv.x(), c.uv.y()));
    };
    double back = 0.0;
    for (const int t : disc.triangles) {
        const auto site = [&](int k) { return mesh.site(mesh.site_of(3 * t + k)); };
        back = std::max(back, backward_distance(work_, mesh.face_of(t), site(0), site(1), site(2)));
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            if (std::find(disc.rim.begin(), disc.rim.end(), h) == disc.rim.end()) {
                add(edge_middle_site(mesh, h));
            }
        }
    }
    return std::max(back, largest_distance(work_.session.ask(std::move(batch)), 0.0));
}

// CAD edges can deviate from their faces by more than the tolerance; there the distance must not increase.
bool CavityOptimiser::near_surface(const Cavity& disc, const Corner& apex, const Vec2& uv, int apex_site) const {
    if (!(sizing_.tolerance > 0.0)) {
        return true;
    }
    const double distance = distance_of_fan(disc, apex, uv, apex_site);
    return distance <= kNear * sizing_.tolerance || distance <= distance_of_disc(disc);
}

std::optional<SurfacePoint> CavityOptimiser::apex_near(const Cavity& disc, const Vec3& p) const {
    const ClassifiedMesh& mesh = work_.mesh;
    Candidate candidate = edge_middle_site(mesh, disc.rim.front());
    candidate.point = p;
    candidate.uv_is_near = false;
    candidate.uv = Vec2::Zero();
    candidate.reach = 0.0;
    for (const int side : disc.rim) {
        candidate.uv += mesh.site(mesh.site_of(side)).uv / static_cast<double>(disc.rim.size());
        candidate.reach =
            std::max(candidate.reach, OptimisationTuning::kMaxApexLift * (mesh.point_of(side) - p).norm());
    }
    return surface_points(work_, {candidate}).front();
}

// Whether the budget has room for the fan.
bool CavityOptimiser::within_budget(const Retriangulation& proposal) {
    const std::size_t now = proposal.disc.triangles.size();
    const std::size_t then = proposal.disc.rim.size() - (proposal.apex_site >= 0 ? 2 : 0);
    return then <= now || work_.check_budget(then - now);
}

bool CavityOptimiser::apply(const Retriangulation& proposal) {
    const ClassifiedMesh& mesh = work_.mesh;
    const Cavity& disc = proposal.disc;
    int site = proposal.apex_site;
    if (!within_budget(proposal)) {
        return false;
    }
    if (site >= 0) {
        const Vec2 uv = mesh.site(site).uv;
        const Corner apex = corner_of(mesh, site);
        if (!rim_apex_legal(mesh, work_.maxmin, disc, site) || !good_enough(disc, apex, site, proposal.before) ||
            !near_surface(disc, apex, uv, site)) {
            return false;
        }
    } else {
        const auto found = apex_near(disc, proposal.apex);
        if (!found || !good_enough(disc, {found->point, found->normal}, -1, proposal.before) ||
            !near_surface(disc, {found->point, found->normal}, found->uv, -1)) {
            return false;
        }
        const int face = mesh.face_of(disc.triangles.front());
        site = work_.mesh.add_site({work_.mesh.add_vertex(found->point, {2, face}), found->uv, found->normal});
    }
    undo_.about_to_remove(disc.triangles);
    const std::vector<int> added = replace_by_fan(work_, disc, site, bound_);
    undo_.added(added);
    requeue_around(added);
    return true;
}

bool CavityOptimiser::slide(int triangle) {
    const auto changed = slider_.improve(
        triangle, bound_, [&](double before) { return enough_after(before); }, undo_);
    undo_.added(changed);
    requeue_around(changed);
    return !changed.empty();
}

// Triangles beside the change that failed before are tried again.
void CavityOptimiser::requeue_around(const std::vector<int>& changed) {
    for (const int t : changed) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            for (const int other : triangles_around(work_.mesh, h)) {
                if (!at_resolution(other)) {
                    failed_.unmark(other);
                    failed_beyond_.unmark(other);
                }
                push_if_bad(other);
            }
        }
    }
}

bool mend(Workspace& work, double min_angle_degrees, const Sizing& sizing) {
    CavityOptimiser mender(work, min_angle_degrees, sizing,
                           OptimisationTuning::kLeastOfAll + OptimisationTuning::kOfAllEach * work.triangles());
    bool changed = mender.improve_once();
    changed = mender.search() || changed;
    work.left_by_mending = mender.attempts_left() == 0 ? mender.bad_triangles().size() : 0;
    close_gaps(work);
    return changed;
}

}  // namespace mq::triangulate
