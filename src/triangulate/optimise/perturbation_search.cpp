// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/angle.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/operators/fan_feasibility.h"
#include "triangulate/optimise/cavity_optimiser.h"
#include "triangulate/optimise/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

// Alignment (a cosine) that is allowed until the repair: at the apex of a slender cone a triangle that replaces two
// spans half of it until its corners have moved.
constexpr double kAlignedForNow = -0.1;
void rename(Cavity& disc, const std::map<int, int>& moved) {
    const auto now = [&](int t) {
        const auto found = moved.find(t);
        return found != moved.end() ? found->second : t;
    };
    for (int& t : disc.triangles) {
        t = now(t);
    }
    for (int& h : disc.rim) {
        h = 3 * now(ClassifiedMesh::triangle_of(h)) + h % 3;
    }
}

double missing_of(const std::vector<double>& angles, double bound) {
    return std::accumulate(angles.begin(), angles.end(), 0.0,
                           [&](double sum, double angle) { return sum + std::max(0.0, bound - angle); });
}

std::vector<double> angles_now(const ClassifiedMesh& mesh, const EditTransaction& trial) {
    std::vector<double> angles;
    for (const int t : trial.now()) {
        angles.push_back(smallest_angle(mesh, t).angle);
    }
    return angles;
}

}  // namespace

// Perturbs at all remaining triangles, the smallest deficit first, since it is the easiest to remove. Ends when failed
// attempts exceed a multiple of those that led to a change, so that the search takes at most that multiple of the time
// of its useful attempts, besides a constant.
bool CavityOptimiser::perturb_all() {
    bool changed = false;
    for (bool again = true; again;) {  // undoing changes the indices of triangles
        again = false;
        std::vector<std::pair<double, int>> bad;
        for (const int t : bad_triangles()) {
            bad.emplace_back(-smallest_angle(work_.mesh, t).angle, t);
        }
        std::sort(bad.begin(), bad.end());
        const int share = std::max(OptimisationTuning::kLeastShare,
                                   OptimisationTuning::kSearchAttempts / std::max(1, static_cast<int>(bad.size())));
        for (const auto& [angle, triangle] : bad) {
            if (vain_attempts_left_ <= 0 || attempts_of_all_ == 0 || work_.over_budget()) {
                return changed;
            }
            const int t = triangle;
            if (work_.exemption_of(t) == nullptr || !mark_tried(t)) {
                continue;
            }
            again = true;
            const Exemption reason = *work_.exemption_of(t);
            attempts_of_search_ = share;
            if (escape(t)) {
                keep(reason);
                changed = true;
                vain_attempts_left_ += std::int64_t{OptimisationTuning::kVainAttempts} * (share - attempts_of_search_);
            } else {
                vain_attempts_left_ -= share - attempts_of_search_;
            }
        }
    }
    return changed;
}

// Whether the triangle has not been tried, identified by the sites around it: undoing gives a triangle another index.
bool CavityOptimiser::mark_tried(int triangle) {
    std::uint64_t key = 0;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        for (const int spoke : work_.mesh.star(h)) {
            key += KeyHash()(static_cast<std::uint64_t>(work_.mesh.site_of(ClassifiedMesh::next(spoke))));
        }
    }
    return tried_to_escape_.insert(key).second;
}

bool CavityOptimiser::budget_spent() const {
    return attempts_of_search_ == 0 || attempts_of_all_ == 0 || work_.over_budget();
}

void CavityOptimiser::count_attempt() {
    --attempts_of_search_;
    --attempts_of_all_;
}

// Tries perturbations. On success the transaction remains open.
bool CavityOptimiser::escape(int triangle) {
    std::vector<Retriangulation> tries = perturbations(triangle);
    bool escaped = false;
    for (auto fan = tries.begin(); fan != tries.end() && !escaped && !budget_spent(); ++fan) {
        work_.progress.check();
        count_attempt();
        undo_.begin();
        escaped = try_perturbation(*fan) && better();
        if (!escaped) {
            const std::map<int, int> moved = undo_.undo();
            std::for_each(fan + 1, tries.end(), [&](Retriangulation& later) { rename(later.disc, moved); });
        }
    }
    return escaped;
}

// Applies a perturbation and repairs the triangles that it made worse.
bool CavityOptimiser::try_perturbation(const Retriangulation& fan) {
    queue_ = {};
    least_aligned_ = kAlignedForNow;
    const bool done = apply(fan);
    least_aligned_ = kAlignedSwap;
    if (done) {
        follow([&](int t) { return move_corner(t); }, -1.0);
        for (const int t : undo_.now()) {
            push_if_bad(t);
        }
        const std::vector<double> before = undo_.angles_before();
        follow([&](int t) { return mend(t); }, *std::min_element(before.begin(), before.end()));
    }
    queue_ = {};
    return done;
}

// Whether the total deficit has decreased sufficiently, and no triangle is worse than the worst one before.
bool CavityOptimiser::better() const {
    const std::vector<double> before = undo_.angles_before();
    const std::vector<double> after = angles_now(work_.mesh, undo_);
    const std::set<int>& now = undo_.now();
    const double least = std::min(kAlignedSwap, undo_.alignment_before());
    return *std::min_element(after.begin(), after.end()) >= *std::min_element(before.begin(), before.end()) &&
           missing_of(after, bound_) < OptimisationTuning::kLeftAfterPerturbation * missing_of(before, bound_) &&
           std::all_of(now.begin(), now.end(), [&](int t) { return alignment(work_.mesh, t) >= least; });
}

// A triangle below the bound after the search need not replace one that was below it before.
void CavityOptimiser::keep(const Exemption& reason) {
    const std::set<int>& now = undo_.now();
    std::vector<int> left;
    std::copy_if(now.begin(), now.end(), std::back_inserter(left),
                 [&](int t) { return work_.exemption_of(t) == nullptr; });
    restore_exemptions(work_, left, bound_, reason);
    undo_.commit();
}

// Relocates one vertex of the triangle, and changes nothing else.
bool CavityOptimiser::move_corner(int triangle) {
    std::vector<Retriangulation> proposals;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const auto disc = disc_of(work_.mesh, triangles_around(work_.mesh, h));
        if (disc && disc->triangles.size() == disc->rim.size()) {
            const double before = smallest_angle(work_.mesh, *disc);
            const double enough = enough_after(before);
            if (!FanFeasibility(work_.mesh, *disc, enough).allow_inner_apex()) {
                continue;
            }
            const Vec3 apex = best_apex(work_.mesh, *disc);
            const double angle = fan_angle(work_.mesh, *disc, apex, -1, enough);
            if (angle >= enough) {
                proposals.push_back({*disc, -1, apex, angle, before});
            }
        }
    }
    return try_best(proposals, 0.0);
}

// Returns fans that result in another number of vertices, the best first.
std::vector<CavityOptimiser::Retriangulation> CavityOptimiser::perturbations(int triangle) const {
    std::vector<Retriangulation> result;
    for (const Cavity& disc : discs_around(triangle)) {
        add_fans(disc, result);
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Retriangulation& a, const Retriangulation& b) { return a.angle > b.angle; });
    return result;
}

void CavityOptimiser::add_fans(const Cavity& disc, std::vector<Retriangulation>& fans) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const double least = OptimisationTuning::kLeastOfPerturbation * bound_;
    const auto keep = [&](int apex_site, const Vec3& apex) {
        const double angle = fan_angle(mesh, disc, apex, apex_site, least);
        if (angle > least) {
            fans.push_back({disc, apex_site, apex, angle, -M_PI});
        }
    };
    const std::size_t inside = (disc.triangles.size() + 2 - disc.rim.size()) / 2;
    for (const int side : inside > 0 ? disc.rim : std::vector<int>()) {
        keep(mesh.site_of(side), mesh.point_of(side));
    }
    if (inside != 1) {
        keep(-1, best_apex(mesh, disc));
    }
}

// Repairs what a perturbation has made worse, by one kind of change, up to a triangle with an angle below `worst`
// (radians) that it cannot improve: the result would be worse than before.
void CavityOptimiser::follow(const std::function<bool(int)>& change, double worst) {
    TriangleMarks tried;
    for (int n = 0; n < OptimisationTuning::kAttemptsAfter && !queue_.empty() && !budget_spent(); ++n) {
        const QueuedTriangle bad = queue_.top();
        queue_.pop();
        count_attempt();
        if (work_.mesh.stamp(bad.triangle) == bad.stamp && !tried.marked(work_.mesh, bad.triangle) &&
            !change(bad.triangle)) {
            if (bad.angle < worst) {
                return;
            }
            tried.mark(work_.mesh, bad.triangle);
        }
    }
}

}  // namespace mq::triangulate
