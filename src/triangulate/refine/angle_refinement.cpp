// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/angle_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/angle.h"
#include "base/for_ranges.h"
#include "base/parallel.h"
#include "triangulate/refine/graded_fans.h"
#include "triangulate/refine/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/edges_angle.h"
#include "triangulate/work_mesh/side_lengths.h"
#include "triangulate/work_mesh/surface_alignment.h"

namespace mq::triangulate {

AngleRefinement::AngleRefinement(Workspace& work, SegmentSplitter& segments, double min_angle_degrees,
                                 Insertion insertion, double chord_height, std::size_t sites_in_round)
    : work_(work),
      segments_(segments),
      bound_(min_angle_degrees * kDegree),
      surely_enough_(sine_squared_above(bound_)),
      insertion_(insertion),
      sites_in_round_(sites_in_round),
      apex_rings_(work, segments, bound_, chord_height),
      graded_fans_(work, segments, bound_),
      turned_(work.settled),
      looked_at_(work.settled) {}

// Tells what is to be queued for a triangle, if anything.
std::optional<AngleRefinement::QueuedTriangle> AngleRefinement::if_bad(int triangle) const {
    const double aligned = alignment(work_.mesh, triangle);
    if (aligned < kWellAligned && !turned_.marked(work_.mesh, triangle)) {
        return QueuedTriangle{aligned - 2.0, triangle, work_.mesh.stamp(triangle)};
    }
    if (squared_sine_of_smallest_angle(work_.mesh, triangle) > surely_enough_) {
        return std::nullopt;
    }
    const double angle = smallest_angle(work_.mesh, triangle).angle;
    return angle < bound_ ? std::optional<QueuedTriangle>({angle, triangle, work_.mesh.stamp(triangle)}) : std::nullopt;
}

void AngleRefinement::push_touched() {
    // Triangles that are worth a thread: about half a millisecond.
    constexpr int kWorthAThread = 2048;
    // Triangles that are examined at a time: the results for all would take as much memory as the mesh.
    constexpr std::size_t kTrianglesAtOnce = 16384;
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    struct Found {
        std::optional<QueuedTriangle> bad;
        std::array<int, 3> encroached{-1, -1, -1};  // segments
    };
    std::vector<Found> found;
    for (std::size_t from = 0; from < touched_.size(); from += kTrianglesAtOnce) {
        found.assign(std::min(kTrianglesAtOnce, touched_.size() - from), {});
        for_chunks(static_cast<int>(found.size()), kWorthAThread, [&](int k) {
            const int t = touched_[from + static_cast<std::size_t>(k)];
            Found& of_triangle = found[static_cast<std::size_t>(k)];
            of_triangle.bad = if_bad(t);
            for (int side = 0; side < 3; ++side) {
                const int s = work_.mesh.segment_of(3 * t + side);
                of_triangle.encroached[static_cast<std::size_t>(side)] = s >= 0 && segments_.encroached(s) ? s : -1;
            }
        });
        for (std::size_t i = 0; i < found.size(); ++i) {
            looked_at_.mark(work_.mesh, touched_[from + i]);
            if (found[i].bad) {
                queue_.push(*found[i].bad);
            }
            for (const int s : found[i].encroached) {
                if (s >= 0) {
                    segments_.request(s);
                }
            }
        }
    }
    touched_.clear();
}

// Touches the triangles that have changed since they were looked at.
void AngleRefinement::push_new() {
    using Triangles = std::vector<int>;
    const auto count = static_cast<std::size_t>(work_.mesh.triangle_count());
    const Triangles changed =
        found_in_ranges<Triangles>(count, [&](std::size_t from, std::size_t to, Triangles& found) {
            for (int t = static_cast<int>(from); t < static_cast<int>(to); ++t) {
                if (!looked_at_.marked(work_.mesh, t)) {
                    found.push_back(t);
                }
            }
        });
    touched_.insert(touched_.end(), changed.begin(), changed.end());
}

// Triangles that have not changed since the last run are good, or known to be infeasible.
void AngleRefinement::run() {
    if (!(bound_ > 0.0)) {
        return;
    }
    push_new();
    bool in_blocks = sites_in_round_ == 0 && insertion_ != Insertion::Circumcentre && !work_.angle_history.running();
    int retries = 0;
    std::optional<State> before;  // the last retry
    const auto retry = [&] {
        if (++retries > RefinementTuning::kMaxRetries || before == state()) {
            return false;
        }
        before = state();
        return retry_exempted();
    };
    for (bool more = true; more;) {
        push_touched();
        if (work_.over_budget()) {
            break;
        }
        if (!segments_.idle()) {
            segments_.run(touched_);
        } else if (std::exchange(in_blocks, false)) {
            refine_in_blocks();
        } else {
            more = refine_round() || retry();
        }
    }
    queue_ = {};
    again_.clear();
    if (work_.over_budget()) {
        exempt_the_rest();
    }
}

// Exempts the triangles that the budget left below the bound.
void AngleRefinement::exempt_the_rest() {
    for (int t = 0; t < work_.mesh.triangle_count(); ++t) {
        work_.progress.check();
        const QueuedTriangle bad{smallest_angle(work_.mesh, t).angle, t, work_.mesh.stamp(t)};
        if (bad.angle < bound_ && work_.exemption_of(t) == nullptr && !exempt_narrow_corner(bad)) {
            exempt(bad, Cause::Budget);
        }
    }
}

// The state counts edges, too: edges that change get new numbers.
AngleRefinement::State AngleRefinement::state() const {
    return {static_cast<std::size_t>(work_.mesh.number_count()), segments_.tried(), segments_.floors().raises(),
            apex_rings_.tried()};
}

// An exempt triangle may have a better neighbourhood by now, and swaps that align badly deviating triangles take
// precedence over a small angle. The neighbourhood of triangles that an earlier run exempted is unchanged.
bool AngleRefinement::retry_exempted() {
    std::vector<int> stack;
    for (auto it = work_.exempt.begin(); it != work_.exempt.end();) {
        const bool final = it->second.cause == Cause::NarrowCorner || work_.settled.marked(work_.mesh, it->first);
        if (final && it->second.stamp == work_.mesh.stamp(it->first)) {
            ++it;
            continue;
        }
        const int t = it->first;
        touched_.push_back(t);
        stack.insert(stack.end(), {3 * t, 3 * t + 1, 3 * t + 2});
        it = work_.exempt.erase(it);
    }
    const bool any = !stack.empty();
    work_.maxmin.restore(stack, touched_, kAlignedAtLast);
    return any;
}

bool AngleRefinement::refine_round() {
    work_.progress.check();
    std::vector<Job> jobs = next_jobs();
    drop_lost(jobs);
    if (jobs.empty()) {
        return !segments_.idle() || !queue_.empty() || !again_.empty() || !touched_.empty();
    }
    std::vector<Candidate> candidates;
    for (const Job& job : jobs) {
        candidates.push_back(job.candidate);
    }
    const auto points = surface_points(work_, candidates);
    for (std::size_t i = 0; i < jobs.size() && !work_.over_budget(); ++i) {
        if (work_.mesh.stamp(jobs[i].bad.triangle) == jobs[i].bad.stamp) {
            work_on(jobs[i], points[i]);
        }
    }
    segments_.floors().check_after(jobs.size());
    return true;
}

// A graded fan can take away the neighbour in which the site of a triangle lies, and its number is that of another
// triangle then, or of none.
void AngleRefinement::drop_lost(std::vector<Job>& jobs) {
    const ClassifiedMesh& mesh = work_.mesh;
    const auto lost = [&](const Job& job) {
        const int t = job.candidate.triangle;
        const bool current = mesh.stamp(job.bad.triangle) == job.bad.stamp;
        const bool gone = t >= mesh.triangle_count() || mesh.gone(t) ||
                          (current && mesh.face_of(t) != mesh.face_of(job.bad.triangle));
        if (gone && current) {
            touched_.push_back(job.bad.triangle);
        }
        return gone;
    };
    jobs.erase(std::remove_if(jobs.begin(), jobs.end(), lost), jobs.end());
}

std::vector<AngleRefinement::Job> AngleRefinement::next_jobs() {
    std::vector<Job> jobs;
    jobs.swap(again_);
    const std::size_t most = sites_in_round_ > 0
                                 ? sites_in_round_
                                 : std::clamp<std::size_t>(queue_.size() / RefinementTuning::kSharesOfQueue,
                                                           RefinementTuning::kMinSites, RefinementTuning::kMaxSites);
    while (!queue_.empty() && jobs.size() < most) {
        const QueuedTriangle bad = queue_.top();
        queue_.pop();
        if (work_.mesh.stamp(bad.triangle) != bad.stamp) {
            continue;
        }
        if (bad.turned()) {
            add_turned(bad, jobs);
            continue;
        }
        if (exempt_narrow_corner(bad) || exempt_where_narrow(bad) || insert_apex_ring(bad) || write_graded_fan(bad)) {
            continue;
        }
        int segment = -1;
        if (const auto site = site_by_rule(bad.triangle, 0, segment)) {
            jobs.push_back({bad, *site, 0});
        } else {
            handle_blocked(bad, segment);
        }
    }
    return jobs;
}

std::optional<Candidate> AngleRefinement::site_by_rule(int triangle, int attempt, int& blocking_segment) const {
    if ((attempt == 0) == (insertion_ == Insertion::Circumcentre)) {
        return circumcentre_site(work_.mesh, triangle, blocking_segment);
    }
    return off_centre_site(work_.mesh, triangle, bound_);
}

// Each triangle is taken once: if its split is refused, it stays.
void AngleRefinement::add_turned(const QueuedTriangle& bad, std::vector<Job>& jobs) {
    turned_.mark(work_.mesh, bad.triangle);
    touched_.push_back(bad.triangle);
    const int h = most_turned_side(work_.mesh, bad.triangle);
    if (side_length(work_.mesh, h) < RefinementTuning::kMinTurned * work_.session.topology().box.largest_side()) {
        return;
    }
    const int segment = work_.mesh.segment_of(h);
    if (segment < 0) {
        jobs.push_back({bad, edge_middle_site(work_.mesh, h), kLastAttempt});
    } else if (narrowest_corner(work_.mesh, segment, 0).angle > kNarrowCorner &&
               narrowest_corner(work_.mesh, segment, 1).angle > kNarrowCorner) {
        segments_.request(segment);
    }
}

// If the smallest angle lies between two segments that meet in its corner, it is an input angle of the shape: exempts
// the triangle, or has the segments halved where only their chords are at fault. Returns whether it was one of both, or
// the apex of a slender cone.
bool AngleRefinement::exempt_narrow_corner(const QueuedTriangle& bad) {
    const int h = smallest_angle(work_.mesh, bad.triangle).half_edge;
    if (slender_apex(h)) {
        exempt(bad, Cause::Apex, work_.mesh.vertex_of(h));
        return true;
    }
    const int segment = work_.mesh.segment_of(h);
    if (segment < 0 || work_.mesh.segment_of(ClassifiedMesh::prev(h)) < 0) {
        return false;
    }
    const int other = work_.mesh.segment_of(ClassifiedMesh::prev(h));
    const int corner = work_.mesh.vertex_of(h);
    if (segments_.opens(corner, segment) || segments_.opens(corner, other)) {
        segments_.request(segment);
        segments_.request(other);
        touched_.push_back(bad.triangle);
    } else if (request_finer_chords(segment, other, corner)) {
        segments_.request(segment, true);
        segments_.request(other, true);
        touched_.push_back(bad.triangle);
    } else {
        exempt(bad, Cause::NarrowCorner, work_.mesh.vertex_of(h), segment);
    }
    return true;
}

bool AngleRefinement::exempt_where_narrow(const QueuedTriangle& bad) {
    const bool narrow = segments_.floors().too_narrow(bad.triangle);
    if (narrow) {
        exempt(bad, work_.too_short());
    }
    return narrow;
}

bool AngleRefinement::write_graded_fan(const QueuedTriangle& bad) {
    return insertion_ != Insertion::Circumcentre && !work_.settled.marked(work_.mesh, bad.triangle) &&
           graded_fans_.write_beside(bad.triangle, touched_);
}

// The angle between chords of curved edges can be smaller than that between the edges, until the chords are short
// enough: returns whether they are to be halved, and counts that.
bool AngleRefinement::request_finer_chords(int a, int b, int vertex) {
    if (segments_.refused(a) || segments_.refused(b) || sharpened_[vertex] >= RefinementTuning::kMaxSharpened) {
        return false;
    }
    const auto angle = angle_between_edges(work_, a, b, vertex);
    if (!angle) {
        return false;
    }
    const auto chord = [&](int segment) {
        const auto& ends = work_.mesh.segment(segment).vertices;
        const int far = ends[0] == vertex ? ends[1] : ends[0];
        return Vec3(work_.mesh.vertex(far).point - work_.mesh.vertex(vertex).point);
    };
    const double enclosed = angle_between(chord(a), chord(b));
    if (angle->least() < kNarrowed * enclosed && (angle->least() < bound_ || enclosed >= bound_)) {
        return false;
    }
    ++sharpened_[vertex];
    return true;
}

// At the apex of a slender cone at least three triangles are needed, whose angles sum up to less than three times the
// bound.
bool AngleRefinement::slender_apex(int h) const {
    constexpr std::size_t kLeastTriangles = 3;  // triangles; fewer do not surround a point
    const auto fan = apex_fan(work_.mesh, h, kLeastTriangles);
    return fan && fan->closed && fan->sum < static_cast<double>(kLeastTriangles) * bound_;
}

bool AngleRefinement::insert_apex_ring(const QueuedTriangle& bad) {
    if (insertion_ == Insertion::Circumcentre ||
        !apex_rings_.insert_ring(smallest_angle(work_.mesh, bad.triangle).half_edge, touched_)) {
        return false;
    }
    touched_.push_back(bad.triangle);
    return true;
}

// A vertex in such a triangle would become the end of a spoke between angles below the bound.
bool AngleRefinement::divides_guarded_fan(const std::vector<int>& triangles) const {
    return std::any_of(triangles.begin(), triangles.end(), [&](int t) {
        const auto narrow = [&](int h) {
            return segments_.is_apex_protected(h) && angle_at(work_.mesh, h) < 2.0 * bound_;
        };
        return narrow(3 * t) || narrow(3 * t + 1) || narrow(3 * t + 2);
    });
}

// The obtuse angle faces a segment, so that its corner encroaches upon it. The triangle changes when the segment is
// split.
void AngleRefinement::handle_blocked(const QueuedTriangle& bad, int segment) {
    if (!split_instead(bad, {segment})) {
        give_up({bad, {}, kLastAttempt}, Cause::Crowded, {segment});
    }
}

bool AngleRefinement::split_instead(const QueuedTriangle& bad, const std::vector<int>& segments) {
    bool any = false;
    for (const int s : segments) {
        if (segments_.may_split(s)) {
            segments_.request(s);
            any = true;
        }
    }
    if (any) {  // the triangle may still exist afterwards
        touched_.push_back(bad.triangle);
    }
    return any;
}

// A site that encroaches only upon segments that cannot be split may still be inserted, unless it would form a
// triangle with too large an angle over one of them.
bool AngleRefinement::flattens_segment(const std::vector<int>& segments, const Vec3& p) const {
    return std::any_of(segments.begin(), segments.end(), [&](int s) { return segments_.in_diametral_lens(s, p); });
}

void AngleRefinement::work_on(const Job& job, const std::optional<SurfacePoint>& p) {
    if (!p) {
        give_up(job, Cause::NoSurfacePoint);
        return;
    }
    const Location place = locate(work_.mesh, job.candidate.triangle, *p);
    if (place.segment >= 0) {
        if (!split_instead(job.bad, {place.segment})) {
            give_up(job, Cause::Crowded, {place.segment});
        }
        return;
    }
    if (place.triangle < 0) {
        give_up(job, Cause::Fold);
        return;
    }
    if (const int corner = narrow_corner_of(work_.mesh, place.triangle); corner >= 0) {
        give_up(job, Cause::NarrowCluster, {work_.mesh.segment_of(corner)});
        return;
    }
    const Surroundings around = surroundings_of(work_.mesh, place.triangle, p->point);
    if (divides_guarded_fan(around.triangles)) {
        give_up(job, Cause::Crowded);
        return;
    }
    if (split_instead(job.bad, around.encroached)) {
        return;
    }
    if (flattens_segment(around.encroached, p->point)) {
        give_up(job, Cause::Crowded, around.encroached);
        return;
    }
    if (around.nearest < segments_.floors().of(work_.mesh.face_of(place.triangle))) {
        give_up(job, around.nearest < work_.shortest_allowed() ? work_.too_short() : Cause::FaceFloorRaised);
        return;
    }
    int shrinks = 0;
    if (crowded(job.bad.triangle, around.nearest, shrinks)) {
        give_up(job, Cause::Crowded);
        return;
    }
    const int vertices = work_.mesh.vertex_count();
    if (const auto refused = insert_vertex(work_, place.triangle, *p, touched_)) {
        if (*refused != Cause::Budget) {
            give_up(job, *refused);
        }
        return;
    }
    remember_shrinks(vertices, shrinks);
    // The site was inserted elsewhere; the triangle is tried again.
    if (work_.mesh.stamp(job.bad.triangle) == job.bad.stamp) {
        touched_.push_back(job.bad.triangle);
    }
}

// In a Delaunay triangulation a circumcentre is at least 1 / (2 sin 25) = 1.18 shortest edges away from every vertex.
// Here that can fail, by the paper's rule for obtuse triangles and by the surface's curvature, and edges would shrink
// from one insertion to the next. For termination, the number of such steps in the ancestry of a vertex is limited.
bool AngleRefinement::crowded(int triangle, double nearest, int& shrinks) const {
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const std::size_t v = work_.mesh.vertex_of(h);
        shrinks = std::max<int>(shrinks, v < work_.shrinks.size() ? work_.shrinks[v] : 0);
    }
    const double shortest = side_length(work_.mesh, shortest_side(work_.mesh, triangle));
    if (nearest >= shortest) {
        return false;
    }
    ++shrinks;
    return shrinks > RefinementTuning::kMaxShrinks || nearest < RefinementTuning::kMaxShrink * shortest;
}

void AngleRefinement::remember_shrinks(int first_vertex, int shrinks) {
    work_.shrinks.resize(work_.mesh.vertex_count(), 0);
    std::fill(work_.shrinks.begin() + first_vertex, work_.shrinks.end(), static_cast<std::uint8_t>(shrinks));
}

void AngleRefinement::give_up(const Job& job, Cause cause, const std::vector<int>& segments) {
    if (job.bad.turned()) {
        return;
    }
    const int h = longest_side(work_.mesh, job.bad.triangle);
    const int segment = work_.mesh.segment_of(h);
    int blocking = -1;
    const auto other = job.attempt == 0 ? site_by_rule(job.bad.triangle, 1, blocking) : std::nullopt;
    if (other) {
        again_.push_back({job.bad, *other, 1});
    } else if (job.attempt < kLastAttempt && segment < 0) {
        again_.push_back({job.bad, edge_middle_site(work_.mesh, h), kLastAttempt});
    } else if (job.attempt == kLastAttempt || !split_instead(job.bad, {segment})) {
        exempt_for(job.bad, cause, segments.empty() && segment >= 0 ? std::vector<int>{segment} : segments);
    }
}

// Whether the smallest angle of a triangle lies at this CAD node, and no corner there is below the bound: too many
// triangles share the corner, which its innermost pieces are too long for. The paper's refinement leaves them.
bool AngleRefinement::shares_wide_corner(int triangle, int vertex) const {
    const ClassifiedMesh& mesh = work_.mesh;
    if (insertion_ == Insertion::Circumcentre || mesh.vertex_of(smallest_angle(mesh, triangle).half_edge) != vertex) {
        return false;
    }
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const auto& ends = mesh.segment(s).vertices;
        if ((ends[0] == vertex || ends[1] == vertex) &&
            narrowest_corner(mesh, s, ends[0] == vertex ? 0 : 1).angle < bound_) {
            return false;
        }
    }
    return true;
}

// Names the blocking segments, and the small input angle if one of them must not be split because of it.
void AngleRefinement::exempt_for(const QueuedTriangle& bad, Cause cause, const std::vector<int>& segments) {
    for (const int s : segments) {
        int corner = -1;
        if (segments_.is_terminal(s, &corner)) {
            if (shares_wide_corner(bad.triangle, corner) && segments_.shrink_shell(corner) && split_instead(bad, {s})) {
                return;
            }
            exempt(bad, Cause::NarrowCluster, corner, s);
            return;
        }
        if (const auto obstacle = segments_.obstacle(s)) {
            exempt(bad, *obstacle, -1, s);
            return;
        }
    }
    const int corner = segments_.narrow_corner_near(work_.mesh.point_of(3 * bad.triangle));
    if (corner >= 0 && cause != work_.too_short() && cause != Cause::FaceFloorRaised) {
        exempt(bad, Cause::NarrowCluster, corner, segments.empty() ? -1 : segments.front());
        return;
    }
    if (cause == Cause::NarrowCluster) {  // blocked by a corner that may still be split
        cause = Cause::Crowded;
    }
    exempt(bad, cause, -1, segments.empty() ? -1 : segments.front());
}

void AngleRefinement::exempt(const QueuedTriangle& bad, Cause cause, int vertex, int segment) {
    const int edge = segment >= 0 ? work_.mesh.segment(segment).edge : -1;
    work_.exempt[bad.triangle] = {cause, vertex, edge, bad.stamp};
}

}  // namespace mq::triangulate
