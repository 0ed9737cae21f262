// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/mender.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/angle.h"
#include "triangulate/corner_angle.h"
#include "triangulate/disc_change.h"
#include "triangulate/distance_probes.h"
#include "triangulate/rim_corners.h"
#include "triangulate/way_back.h"

namespace mq::triangulate {

namespace {

using geometry::Query;
using mesh::SurfaceMesh;

// What a change must gain at least: a part of what is missing, so that many small changes end, and in radians.
constexpr double kGainOfMissing = 0.05;
constexpr double kGain = 1e-6;
// What is aimed at lies above the bound by so much, radians, or it would be approached without end.
constexpr double kMargin = 0.002 * kDegree;
constexpr std::size_t kMaxTried = 6;
// Attempts: so many for each triangle that is bad at first, and no more than so many and a part of the number of all
// triangles, so that parts full of needles do not take for ever.
constexpr std::size_t kAttemptsEach = 40;
constexpr std::size_t kAttempts = 2000;
constexpr std::size_t kTrianglesPerAttempt = 4;
constexpr int kMaxGrowth = 3;
// By how much triangles beside bad ones are made better than the bound, radians, and how often that is tried.
constexpr double kRoom = 3.0 * kDegree;
constexpr int kMaxRounds = 6;
constexpr double kLeftAfterRound = 0.95;  // of what was missing, or it is the last
constexpr int kMostWorse = 2;             // rounds, one after the other: another one may find a way out
constexpr double kMaxLift = 0.5;
constexpr std::size_t kMostFound = 200'000;  // discs that are remembered
// A fan of more triangles has no angle worth the search; where a surface shrinks to a point, thousands meet in a
// vertex.
constexpr std::size_t kMostTriangles = 64;

void add_disc(const SurfaceMesh& mesh, std::vector<int> triangles, std::vector<Disc>& discs) {
    if (triangles.size() > kMostTriangles) {
        return;
    }
    if (auto disc = disc_of(mesh, std::move(triangles))) {
        discs.push_back(std::move(*disc));
    }
}

}  // namespace

Mender::Mender(Workspace& work, double min_angle_degrees, const Sizing& sizing)
    : work_(work), bound_(min_angle_degrees * kDegree), sizing_(sizing), slider_(work, sizing), undo_(work) {
    want(bound_ + kMargin);
}

// The part itself has the angle.
bool Mender::hopeless(int triangle) const {
    const Exemption* exemption = work_.exemption_of(triangle);
    return exemption != nullptr && (exemption->cause == Cause::NarrowCorner || exemption->cause == Cause::Apex);
}

double Mender::enough_after(double before) const {
    return before + kGain + kGainOfMissing * std::max(0.0, wanted_ - before);
}

// Tips that end within nothing are tried once.
bool Mender::at_resolution(int triangle) const {
    const Exemption* exemption = work_.exemption_of(triangle);
    return exemption != nullptr && (exemption->cause == Cause::Resolution || exemption->cause == Cause::Abandoned);
}

void Mender::want(double angle) {
    found_.clear();
    wanted_ = angle;
    surely_enough_ = surely_beyond(angle);
}

void Mender::push_if_bad(int triangle) {
    if (squared_sine_of_smallest(work_.mesh, triangle) > surely_enough_) {
        return;
    }
    const double angle = smallest_angle(work_.mesh, triangle).angle;
    if (angle < wanted_ && !hopeless(triangle) && (angle < bound_ || near(triangle))) {
        queue_.push({angle, triangle, work_.mesh.stamp(triangle)});
    }
}

bool Mender::near(int triangle) const {
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (std::binary_search(near_.begin(), near_.end(), work_.mesh.vertex_of(h))) {
            return true;
        }
    }
    return false;
}

void Mender::push_all() {
    queue_ = {};
    failed_.clear();
    exhausted_.clear();
    for (int t = 0; t < work_.mesh.triangle_count(); ++t) {
        if (!work_.mesh.gone(t)) {
            push_if_bad(t);
        }
    }
}

bool Mender::change_singly() {
    push_all();
    return work_off();
}

bool Mender::make_room_and_change() {
    make_room();
    return change_singly();
}

bool Mender::run(const std::vector<Escape>& escapes, double missing_before) {
    bool changed = false;
    int worse = 0;
    double left = missing_before;
    for (int round = 0; round < kMaxRounds && left > 0.0; ++round) {
        changed = (round > 0 && make_room_and_change()) || changed;
        for (const Escape kinds : escapes) {
            changed = escape_all(kinds) || changed;
        }
        const double now = missing();
        worse = now > left ? worse + 1 : 0;
        if (worse == kMostWorse || (worse == 0 && now > kLeftAfterRound * left)) {
            break;
        }
        left = std::min(left, now);
    }
    return changed;
}

double Mender::missing() const {
    const std::vector<int> bad = bad_triangles();
    return std::accumulate(bad.begin(), bad.end(), 0.0,
                           [&](double sum, int t) { return sum + bound_ - smallest_angle(work_.mesh, t).angle; });
}

// Takes what is in the queue and what comes into it.
bool Mender::work_off() {
    bool changed = false;
    const std::size_t most =
        std::min(kAttemptsEach * queue_.size(),
                 kAttempts + static_cast<std::size_t>(work_.mesh.triangle_count()) / kTrianglesPerAttempt);
    for (std::size_t attempts = 0; !queue_.empty() && attempts < most && !work_.over_budget();) {
        work_.progress.check();
        const Bad bad = queue_.top();
        queue_.pop();
        if (work_.mesh.stamp(bad.triangle) != bad.stamp || failed_.marked(work_.mesh, bad.triangle)) {
            continue;
        }
        ++attempts;
        if (mend(bad.triangle)) {
            changed = true;
        } else {
            failed_.mark(work_.mesh, bad.triangle);
        }
    }
    return changed;
}

std::vector<int> Mender::bad_triangles() const {
    std::vector<int> bad;
    for (const auto& [triangle, exemption] : work_.exempt) {
        if (work_.exemption_of(triangle) != nullptr && !hopeless(triangle) && !at_resolution(triangle) &&
            smallest_angle(work_.mesh, triangle).angle < bound_) {
            bad.push_back(triangle);
        }
    }
    return bad;
}

// Good triangles beside bad ones hold these fast when they are just good enough.
void Mender::make_room() {
    std::set<int> vertices;
    std::set<int> visited;  // sites: each bad triangle of a fan has the whole fan around its apex
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
    near_.assign(vertices.begin(), vertices.end());
    want(bound_ + kRoom);
    push_all();
    work_off();
    want(bound_ + kMargin);
    near_.clear();
}

std::vector<Disc> Mender::discs_around(int triangle) const {
    const SurfaceMesh& mesh = work_.mesh;
    std::vector<Disc> discs;
    std::vector<int> with_neighbours{triangle};
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        add_disc(mesh, triangles_around(mesh, h), discs);
        const int g = mesh.twin(h);
        if (g < 0) {
            continue;
        }
        with_neighbours.push_back(SurfaceMesh::triangle_of(g));
        add_disc(mesh, {triangle, SurfaceMesh::triangle_of(g)}, discs);
        std::vector<int> both = triangles_around(mesh, h);
        const std::vector<int> other = triangles_around(mesh, SurfaceMesh::next(h));
        both.insert(both.end(), other.begin(), other.end());
        add_disc(mesh, std::move(both), discs);
    }
    add_disc(mesh, std::move(with_neighbours), discs);
    return discs;
}

// Most discs are met again, beside another bad triangle or in another trial.
const Mender::Found& Mender::fans_of(const Disc& disc) {
    if (found_.size() > kMostFound) {
        found_.clear();
    }
    const auto [place, fresh] = found_.try_emplace(state_key(work_.mesh, disc.triangles));
    if (fresh) {
        place.value() = search_fans(disc);
    }
    return place->second;
}

Mender::Found Mender::search_fans(const Disc& disc) const {
    Found found;
    found.before = smallest_angle(work_.mesh, disc);
    const double enough = enough_after(found.before);
    const auto keep = [&](int apex_site, const Vec3& apex, double angle) {
        if (angle >= enough) {
            found.fans.push_back({apex_site, apex, angle});
        }
    };
    const RimCorners corners(work_.mesh, disc, enough);
    for (std::size_t k = 0; k < disc.rim.size(); ++k) {
        if (corners.allow_apex(k)) {
            const int site = work_.mesh.site_of(disc.rim[k]);
            const Vec3& apex = work_.mesh.point_of(disc.rim[k]);
            keep(site, apex, fan_angle(work_.mesh, disc, apex, site));
        }
    }
    const Vec3 apex = corners.allow_inner_apex() ? best_apex(work_.mesh, disc, enough) : rough_apex(work_.mesh, disc);
    const double angle = fan_angle(work_.mesh, disc, apex);
    keep(-1, apex, angle);
    found.over = angle >= wanted_ ? -1 : worst_side(work_.mesh, disc, apex);
    return found;
}

// @return the worst side, over which a larger disc may do better; -1: none is needed, or there is none.
int Mender::propose(const Disc& disc, std::vector<Proposal>& proposals) {
    const Found& found = fans_of(disc);
    for (const Fan& fan : found.fans) {
        if (!reopens_ear(disc, fan.apex_site)) {
            proposals.push_back({disc, fan.apex_site, fan.apex, fan.angle, found.before});
        }
    }
    return found.over;
}

// With the neighbours over these sides, of each disc the one with the same index; -1: none of it.
std::vector<Disc> Mender::grown(const std::vector<Disc>& discs, const std::vector<int>& over) const {
    std::vector<Disc> result;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        const int g = over[i] < 0 ? -1 : work_.mesh.twin(over[i]);
        if (g >= 0) {
            std::vector<int> triangles = discs[i].triangles;
            triangles.push_back(SurfaceMesh::triangle_of(g));
            add_disc(work_.mesh, std::move(triangles), result);
        }
    }
    return result;
}

// Small discs first; once one of them reaches the bound that will do.
bool Mender::mend(int triangle) {
    std::vector<Proposal> proposals;
    std::vector<Disc> discs = discs_around(triangle);
    std::vector<std::uint64_t> keys;
    const auto smaller = [](const Disc& a, const Disc& b) { return a.triangles.size() < b.triangles.size(); };
    const auto known = [&](const Disc& disc) {
        keys.push_back(state_key(work_.mesh, disc.triangles));
        return exhausted_.count(keys.back()) > 0;
    };
    discs.erase(std::remove_if(discs.begin(), discs.end(), known), discs.end());
    for (int growth = 0; growth <= kMaxGrowth; ++growth) {
        std::stable_sort(discs.begin(), discs.end(), smaller);
        std::vector<int> worst_sides;
        for (auto disc = discs.begin(); disc != discs.end(); ++disc) {
            worst_sides.push_back(propose(*disc, proposals));
            const bool last_of_size = disc + 1 == discs.end() || smaller(*disc, *(disc + 1));
            if (last_of_size && try_best(proposals, wanted_)) {
                return true;
            }
        }
        if (growth < kMaxGrowth) {
            discs = grown(discs, worst_sides);
        }
    }
    if (((undo_.empty() || kinds_ != Escape::Fans) && slide(triangle)) || try_best(proposals, 0.0)) {
        return true;
    }
    if (undo_.empty()) {
        exhausted_.insert(keys.begin(), keys.end());
    }
    return false;
}

// Takes what it tried out of the proposals.
bool Mender::try_best(std::vector<Proposal>& proposals, double at_least) {
    std::stable_sort(proposals.begin(), proposals.end(), [&](const Proposal& a, const Proposal& b) {
        const double first = std::min(a.angle, wanted_);
        const double second = std::min(b.angle, wanted_);
        return first != second ? first > second : a.disc.triangles.size() < b.disc.triangles.size();
    });
    std::size_t tried = 0;
    while (tried < proposals.size() && tried < kMaxTried && proposals[tried].angle >= at_least) {
        if (carry_out(proposals[tried])) {
            return true;
        }
        ++tried;
    }
    proposals.erase(proposals.begin(), proposals.begin() + static_cast<std::ptrdiff_t>(tried));
    return false;
}

bool Mender::good_enough(const Disc& disc, const Corner& apex, int apex_site, double before) const {
    const double least = std::min(least_aligned_, disc_alignment(work_.mesh, disc));
    return fan_angle(work_.mesh, disc, apex.point, apex_site) >= enough_after(before) &&
           fan_alignment(work_.mesh, disc, apex, apex_site) >= least &&
           within_bounds(work_, sizing_, disc, apex, apex_site);
}

// Over the middles of the spokes, and where these and the fan's triangles are expected to be farthest.
double Mender::distance_of_fan(const Disc& disc, const Corner& apex, const Vec2& uv, int apex_site) const {
    const SurfaceMesh& mesh = work_.mesh;
    const SurfaceMesh::Site top{-1, uv, apex.normal, apex.point};
    geometry::Engine::Batch batch;
    double back = 0.0;
    const int face = mesh.face_of(disc.triangles.front());
    for (const int side : disc.rim) {
        const SurfaceMesh::Site& a = mesh.site(mesh.site_of(side));
        const SurfaceMesh::Site& b = mesh.site(mesh.site_of(SurfaceMesh::next(side)));
        add_edge_probes(work_, face, a, top, batch);
        if (mesh.site_of(side) != apex_site && mesh.site_of(SurfaceMesh::next(side)) != apex_site) {
            add_triangle_probe(work_, face, a, b, top, batch);
            back = std::max(back, way_back(work_, face, a, b, top));
        }
    }
    return std::max(back, largest_distance(work_.session.ask(std::move(batch)), 0.0));
}

// Over the middles of the inner edges that are there, and under the part's points.
double Mender::distance_of_disc(const Disc& disc) const {
    const SurfaceMesh& mesh = work_.mesh;
    geometry::Engine::Batch batch;
    const auto add = [&](const Candidate& c) {
        batch.push_back(Query::face_nearest(mesh.face_of(c.triangle), work_.grid.to_part(c.point), c.uv.x(), c.uv.y()));
    };
    double back = 0.0;
    for (const int t : disc.triangles) {
        const auto site = [&](int k) { return mesh.site(mesh.site_of(3 * t + k)); };
        back = std::max(back, way_back(work_, mesh.face_of(t), site(0), site(1), site(2)));
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            if (std::find(disc.rim.begin(), disc.rim.end(), h) == disc.rim.end()) {
                add(edge_middle_site(mesh, h));
            }
        }
    }
    return std::max(back, largest_distance(work_.session.ask(std::move(batch)), 0.0));
}

// CAD edges can lie off their faces by more than the tolerance; there it must not become worse.
bool Mender::near_surface(const Disc& disc, const Corner& apex, const Vec2& uv, int apex_site) const {
    if (!(sizing_.tolerance > 0.0)) {
        return true;
    }
    const double distance = distance_of_fan(disc, apex, uv, apex_site);
    return distance <= kNear * sizing_.tolerance || distance <= distance_of_disc(disc);
}

std::optional<SurfacePoint> Mender::apex_near(const Disc& disc, const Vec3& p) const {
    const SurfaceMesh& mesh = work_.mesh;
    Candidate candidate = edge_middle_site(mesh, disc.rim.front());
    candidate.point = p;
    candidate.uv_is_near = false;
    candidate.uv = Vec2::Zero();
    candidate.reach = 0.0;
    for (const int side : disc.rim) {
        candidate.uv += mesh.site(mesh.site_of(side)).uv / static_cast<double>(disc.rim.size());
        candidate.reach = std::max(candidate.reach, kMaxLift * (mesh.point_of(side) - p).norm());
    }
    return surface_points(work_, {candidate}).front();
}

bool Mender::carry_out(const Proposal& proposal) {
    const SurfaceMesh& mesh = work_.mesh;
    const Disc& disc = proposal.disc;
    int site = proposal.apex_site;
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
    const std::vector<int> fan = replace(disc, site);
    return proposal.ear_site < 0 || cut_ear(fan, proposal.ear_site, site);
}

std::vector<int> Mender::replace(const Disc& disc, int apex_site) {
    undo_.about_to_remove(disc.triangles);
    const std::vector<int> added = put_fan(work_, disc, apex_site, bound_);
    undo_.added(added);
    look_again_around(added);
    return added;
}

bool Mender::slide(int triangle) {
    const auto changed = slider_.improve(
        triangle, bound_, [&](double before) { return enough_after(before); }, undo_);
    undo_.added(changed);
    look_again_around(changed);
    return !changed.empty();
}

// What failed beside it gets another chance.
void Mender::look_again_around(const std::vector<int>& changed) {
    for (const int t : changed) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            for (const int other : triangles_around(work_.mesh, h)) {
                if (!at_resolution(other)) {
                    failed_.unmark(other);
                }
                push_if_bad(other);
            }
        }
    }
}

namespace {

/// What mending changes.
struct State {
    SurfaceMesh mesh;
    std::map<int, Exemption> exempt;

    explicit State(const Workspace& work) : mesh(work.mesh), exempt(work.exempt) {}
    void put_back(Workspace& work) const {
        work.mesh.become(mesh);
        work.maxmin.look_again();
        work.exempt = exempt;
    }
};

// By simple ones; where something is left, it begins anew with all of them, and the better end stays. Either can end in
// a place that the other finds a way around.
bool mend_by_escapes(Workspace& work, double min_angle_degrees, const Sizing& sizing, double missing) {
    using Escape = Mender::Escape;
    const State before(work);
    Mender simple(work, min_angle_degrees, sizing);
    const bool changed = simple.run({Escape::Fans}, missing);
    const double left = simple.missing();
    if (!(left > 0.0)) {
        return changed;
    }
    const State after(work);
    before.put_back(work);
    Mender thorough(work, min_angle_degrees, sizing);
    if (thorough.run({Escape::All, Escape::TwoInARow}, missing) && thorough.missing() < left) {
        return true;
    }
    after.put_back(work);
    return changed;
}

}  // namespace

bool mend(Workspace& work, double min_angle_degrees, const Sizing& sizing) {
    Mender mender(work, min_angle_degrees, sizing);
    bool changed = mender.change_singly();
    const double missing = mender.missing();
    if (missing > 0.0) {
        changed = mender.make_room_and_change() || changed;
        changed = mend_by_escapes(work, min_angle_degrees, sizing, missing) || changed;
    }
    close_gaps(work);
    return changed;
}

}  // namespace mq::triangulate
