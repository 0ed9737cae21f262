// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "triangulate/corner_angle.h"
#include "triangulate/mender.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

// Changes for the worse: to no less than so much of the bound, so many at a triangle, with so many attempts to mend
// what is around, of each kind and in all, and to be kept only if so much at most is left of what was missing.
constexpr double kLeastOfKick = 0.2;
constexpr std::size_t kMaxKicks = 40;
constexpr int kAttemptsAfterKick = 150;
constexpr std::size_t kAttemptsInAll = 20000;
constexpr double kLeftAfterKick = 0.95;
// Where more are left, the part is to blame.
constexpr std::size_t kMostLeft = 200;

void rename(Disc& disc, const std::map<int, int>& moved) {
    const auto now = [&](int t) {
        const auto found = moved.find(t);
        return found != moved.end() ? found->second : t;
    };
    for (int& t : disc.triangles) {
        t = now(t);
    }
    for (int& h : disc.rim) {
        h = 3 * now(SurfaceMesh::triangle_of(h)) + h % 3;
    }
}

}  // namespace

// What is left; first what misses least, which is helped most easily.
bool Mender::escape_all() {
    bool changed = false;
    for (bool again = true; again;) {  // what is undone has other indices
        again = false;
        std::vector<std::pair<double, int>> bad;
        for (const int t : bad_triangles()) {
            bad.emplace_back(-smallest_angle(work_.mesh, t).angle, t);
        }
        if (bad.size() > kMostLeft) {
            return changed;
        }
        std::sort(bad.begin(), bad.end());
        for (const auto& [angle, t] : bad) {
            if (work_.exemption_of(t) != nullptr && first_escape(t)) {
                again = true;
                changed = escape(t) || changed;
            }
        }
    }
    return changed;
}

// By its sites: after what was undone it is another triangle, but not a better one.
bool Mender::first_escape(int triangle) {
    std::uint64_t key = 0;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        key += KeyHash()(static_cast<std::uint64_t>(work_.mesh.site_of(h)));
    }
    return tried_to_escape_.insert(key).second;
}

bool Mender::escape(int triangle) {
    std::vector<Proposal> tries = kicks(triangle);
    for (auto kick = tries.begin(); kick != tries.end() && escape_attempts_ < kAttemptsInAll && !work_.over_budget();
         ++kick) {
        work_.progress.check();
        RegionUndo undo(work_);
        if (better_after(*kick, undo)) {
            return true;
        }
        const std::map<int, int> moved = undo.undo();
        std::for_each(kick, tries.end(), [&](Proposal& later) { rename(later.disc, moved); });
    }
    return false;
}

// A vertex of it, and nothing else.
bool Mender::move_corner(int triangle) {
    std::vector<Proposal> proposals;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const auto disc = disc_of(work_.mesh, triangles_around(work_.mesh, h));
        if (disc && disc->triangles.size() == disc->rim.size()) {
            const double before = smallest_angle(work_.mesh, *disc);
            const Vec3 apex = best_apex(work_.mesh, *disc, enough_after(before));
            const double angle = fan_angle(work_.mesh, *disc, apex);
            if (angle >= enough_after(before)) {
                proposals.push_back({*disc, -1, apex, angle, before});
            }
        }
    }
    return try_best(proposals, 0.0);
}

// Changes that leave another number of vertices, the best first.
std::vector<Mender::Proposal> Mender::kicks(int triangle) const {
    const SurfaceMesh& mesh = work_.mesh;
    std::vector<Proposal> result;
    const auto keep = [&](const Disc& disc, int apex_site, const Vec3& apex) {
        const double angle = fan_angle(mesh, disc, apex, apex_site);
        if (angle > kLeastOfKick * bound_) {
            result.push_back({disc, apex_site, apex, angle, -M_PI});
        }
    };
    for (const Disc& disc : discs_around(triangle)) {
        const std::size_t inside = (disc.triangles.size() + 2 - disc.rim.size()) / 2;
        for (const int side : inside > 0 ? disc.rim : std::vector<int>()) {
            keep(disc, mesh.site_of(side), mesh.point_of(side));
        }
        if (inside != 1) {
            keep(disc, -1, best_apex(mesh, disc, kLeastOfKick * bound_));
        }
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Proposal& a, const Proposal& b) { return a.angle > b.angle; });
    result.resize(std::min(result.size(), kMaxKicks));
    return result;
}

// What a kick has made worse, by one kind of change.
void Mender::follow(const std::function<bool(int)>& change) {
    TriangleMarks tried;
    for (int n = 0; n < kAttemptsAfterKick && !queue_.empty() && !work_.over_budget(); ++n) {
        const Bad bad = queue_.top();
        queue_.pop();
        ++escape_attempts_;
        if (work_.mesh.stamp(bad.triangle) == bad.stamp && !tried.marked(work_.mesh, bad.triangle) &&
            !change(bad.triangle)) {
            tried.mark(work_.mesh, bad.triangle);
        }
    }
}

// What is missing of the bound around must become less in all, and nothing worse than the worst there was.
bool Mender::better_after(Proposal& kick, RegionUndo& undo) {
    undo_ = &undo;
    queue_ = {};
    bool better = false;
    if (carry_out(kick)) {
        follow([&](int t) { return move_corner(t); });
        for (const int t : undo.now()) {
            push_if_bad(t);
        }
        follow([&](int t) { return mend(t); });
        const auto missing = [&](double sum, double angle) { return sum + std::max(0.0, bound_ - angle); };
        std::vector<double> after;
        for (const int t : undo.now()) {
            after.push_back(smallest_angle(work_.mesh, t).angle);
        }
        const std::vector<double>& before = undo.angles_before();
        better = *std::min_element(after.begin(), after.end()) >= *std::min_element(before.begin(), before.end()) &&
                 std::accumulate(after.begin(), after.end(), 0.0, missing) <
                     kLeftAfterKick * std::accumulate(before.begin(), before.end(), 0.0, missing);
    }
    queue_ = {};
    undo_ = nullptr;
    return better;
}

}  // namespace mq::triangulate
