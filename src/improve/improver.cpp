// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/improver.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "base/angle.h"
#include "base/tuning.h"
#include "improve/tuning.h"
#include "mesh/intersection/triangle_distance.h"
#include "mesh/quality/triangle_quality.h"

namespace mq::improve {

namespace {

constexpr double kTolerance = 1e-3;  // default tolerance as a fraction of the largest dimension

double size_of(const mesh::TriangleMesh& mesh) {
    Box box;
    for (const Vec3& p : mesh.vertices) {
        box.add(p);
    }
    return box.largest_side();
}

}  // namespace

Improver::Improver(const mesh::TriangleMesh& given, const ImproveOptions& options, Progress& progress,
                   const mesh::AabbTree* frozen)
    : options_(options),
      tolerance_(options.tolerance > 0.0 ? options.tolerance : kTolerance * size_of(given)),
      progress_(progress),
      frozen_(frozen),
      mesh_(given, options.feature_angle * kDegree),
      surface_(given, mesh_),
      bend_(options.feature_angle * kDegree),
      shortest_(ImproveTuning::kShortestUnits * std::numeric_limits<float>::epsilon() * size_of(given)),
      most_triangles_(ImproveTuning::kMostGrowth * mesh_.triangle_count() + ImproveTuning::kMoreTriangles),
      witnesses_(given.triangles.size()),
      halvings_(given.vertices.size()),
      changed_(given.vertices.size()),
      around_(given.vertices.size()),
      worst_(given.vertices.size()),
      mended_(given.triangles.size()),
      moved_(given.vertices.size()) {
    for (const Triangle& t : given.triangles) {
        angles_.push_back(smallest_angle(t));
    }
}

void Improver::run() {
    bool splits = false;
    int since = 0;
    const double at_first = std::max(1.0, static_cast<double>(bad_triangles().size()));
    for (int round = 0; since <= kMostRounds; ++round) {
        const std::vector<int> bad_ones = bad_triangles();
        since = keep_if_best(bad_ones.size()) ? 0 : since + 1;
        progress_.advance(1.0 - std::min(1.0, static_cast<double>(fewest_bad_) / at_first));
        bool changed = false;
        for (const int t : bad_ones) {
            progress_.check();
            if (mesh_.gone(t) || !bad(t)) {
                continue;
            }
            changed = (mend(t) || (splits && !forced(t) && refine(t))) || changed;
        }
        if (!changed && splits) {
            break;
        }
        splits = splits || !changed || round + 1 >= ImproveTuning::kRoundsWithoutSplits;
    }
    if (bad_triangles().size() >= fewest_bad_) {
        // Where refinement does not end, between sharp edges at small angles, the last state may have more bad
        // triangles than an earlier one.
        mesh_.restore(std::move(*best_));
        counts = best_counts_;
    }
}

bool Improver::keep_if_best(std::size_t bad) {
    if (best_ && bad >= fewest_bad_) {
        return false;
    }
    fewest_bad_ = bad;
    best_ = mesh_.state();
    best_counts_ = counts;
    return true;
}

std::vector<std::pair<int, mesh::ExemptCause>> Improver::left() const {
    std::vector<std::pair<int, mesh::ExemptCause>> result;
    for (const int t : bad_triangles()) {
        result.emplace_back(t, forced(t) ? mesh::ExemptCause::SharpEdges : mesh::ExemptCause::NoChangeWithinTolerance);
    }
    std::sort(result.begin(), result.end());
    return result;
}

double Improver::smallest_angle(const Triangle& t) const {
    return mesh::min_angle_of(mesh_.corners(t));
}

bool Improver::bad(int t) const {
    return angles_[t] < options_.min_angle;
}

bool Improver::forced(int t) const {
    const Triangle& c = mesh_.triangle(t);
    const std::array<Vec3, 3> p = mesh_.corners(c);
    // The corner opposite the shortest edge.
    std::size_t at = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const double length = (p[(i + 2) % 3] - p[(i + 1) % 3]).norm();
        if (length < shortest) {
            shortest = length;
            at = i;
        }
    }
    return mesh_.is_sharp(c[at], c[(at + 1) % 3]) && mesh_.is_sharp(c[at], c[(at + 2) % 3]);
}

std::vector<int> Improver::bad_triangles() const {
    std::vector<std::pair<double, int>> found;
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
        if (!mesh_.gone(t) && bad(t)) {
            found.emplace_back(angles_[t], t);
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<int> result;
    for (const auto& [angle, t] : found) {
        result.push_back(t);
    }
    return result;
}

bool Improver::mend(int t) {
    if (same_around(t, mended_[t])) {
        return false;
    }
    if (swap_some(t) || collapse_some(t) || move_some(t)) {
        return true;
    }
    mended_[t] = now_;
    return false;
}

bool Improver::same_around(int t, int since) const {
    const Triangle& c = mesh_.triangle(t);
    return std::all_of(c.begin(), c.end(), [&](int v) { return around_[v] < since; });
}

void Improver::note_changed(const LocalOperation& change) {
    std::vector<int> touched;
    for (const int t : change.removed) {
        touched.insert(touched.end(), mesh_.triangle(t).begin(), mesh_.triangle(t).end());
    }
    for (const Triangle& t : change.added) {
        touched.insert(touched.end(), t.begin(), t.end());
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const int v : touched) {
        changed_[v] = around_[v] = now_;
        for (const int t : mesh_.star(v)) {
            for (const std::int32_t w : mesh_.triangle(t)) {
                around_[w] = now_;
            }
        }
    }
    ++now_;
}

double Improver::worst_angle_at(int v) {
    auto& [found_at, worst] = worst_[v];
    if (found_at <= changed_[v]) {
        worst = 180.0;
        for (const int t : mesh_.star(v)) {
            worst = std::min(worst, angles_[t]);
        }
        found_at = now_;
    }
    return worst;
}

bool Improver::betters(int v, const Vec3& place, int without) {
    const double least = worst_angle_at(v) + ImproveTuning::kLeastAngleGain;
    const std::vector<int>& star = mesh_.star(v);
    return std::all_of(star.begin(), star.end(), [&](int t) {
        const Triangle& c = mesh_.triangle(t);
        std::array<Vec3, 3> corners = mesh_.corners(c);
        for (std::size_t i = 0; i < 3; ++i) {
            if (c[i] == without) {
                return true;
            }
            if (c[i] == v) {
                corners[i] = place;
            }
        }
        return mesh::min_angle_of(corners) > least;
    });
}

bool Improver::swap_some(int t) {
    const Triangle c = mesh_.triangle(t);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto change = swap_edge(mesh_, c[i], c[(i + 1) % 3]);
        if (change && attempt(*change, Rule::Better)) {
            ++counts.flips;
            return true;
        }
    }
    return false;
}

bool Improver::collapse_some(int t) {
    const Triangle c = mesh_.triangle(t);
    std::array<std::size_t, 3> order{0, 1, 2};
    const auto length = [&](std::size_t i) { return (mesh_.point(c[(i + 1) % 3]) - mesh_.point(c[i])).norm(); };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return length(i) < length(j); });
    for (const std::size_t i : order) {
        const int a = c[i], b = c[(i + 1) % 3];
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
            // Vertices inserted by halving stay, as they would otherwise be removed and inserted without end.
            const bool may_go = halvings_[from] == 0 && betters(from, mesh_.point(to), to);
            const auto change = may_go ? collapse_edge(mesh_, from, to, bend_) : std::nullopt;
            if (change && attempt(*change, Rule::Better, {mesh_.point(from)})) {
                ++counts.collapses;
                return true;
            }
        }
    }
    return false;
}

bool Improver::move_some(int t) {
    const Triangle c = mesh_.triangle(t);
    return std::any_of(c.begin(), c.end(), [&](int v) { return move(v); });
}

bool Improver::move(int v) {
    const Freedom free = freedom(mesh_, v, bend_);
    if (free == Freedom::None || changed_[v] < moved_[v]) {
        return false;
    }
    const std::vector<int> around = free == Freedom::Curve ? mesh_.sharp_neighbours(v) : mesh_.neighbours(v);
    Vec3 centre = Vec3::Zero();
    for (const int w : around) {
        centre += mesh_.point(w) / static_cast<double>(around.size());
    }
    const Vec3 here = mesh_.point(v);
    for (const double step : {1.0, 0.5, 0.25, 0.125}) {
        const Vec3 there = here + step * (centre - here);
        const Vec3 p = free == Freedom::Curve ? surface_.project_to_sharp_edges(there) : surface_.project(there);
        if (p == here || !betters(v, p)) {
            continue;
        }
        const int other = add_vertex(p, halvings_[v]);
        if (attempt(replace_vertex(mesh_, v, other), Rule::Better, {here})) {
            ++counts.moves;
            return true;
        }
        forget_last_vertex();
    }
    moved_[v] = now_;
    return false;
}

bool Improver::refine(int t) {
    if (mesh_.alive_count() >= most_triangles_) {
        return false;
    }
    // Walks along the longest edges to one that is the longest of both its triangles, or sharp.
    const auto longest = [&](int s) {
        const Triangle& c = mesh_.triangle(s);
        std::array<std::pair<double, std::array<int, 2>>, 3> edges;
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = c[i], b = c[(i + 1) % 3];
            edges[i] = {(mesh_.point(b) - mesh_.point(a)).norm(), {std::min(a, b), std::max(a, b)}};
        }
        return *std::max_element(edges.begin(), edges.end());
    };
    auto edge = longest(t);
    for (;;) {
        const std::vector<int> sides = mesh_.around_edge(edge.second[0], edge.second[1]);
        if (mesh_.is_sharp(edge.second[0], edge.second[1])) {
            break;
        }
        const auto best = std::max(longest(sides[0]), longest(sides[1]));
        if (best.second == edge.second) {
            break;
        }
        edge = best;
    }
    return split(edge.second[0], edge.second[1]);
}

bool Improver::split(int a, int b) {
    const Vec3 middle = mesh_.is_sharp(a, b) ? on_a_shell(a, b) : Vec3(0.5 * (mesh_.point(a) + mesh_.point(b)));
    const int halvings = 1 + std::max(halvings_[a], halvings_[b]);
    if (halvings > ImproveTuning::kMostEdgeHalvings || (mesh_.point(b) - mesh_.point(a)).norm() < 2.0 * shortest_) {
        return false;
    }
    const Vec3 p = mesh_.is_sharp(a, b) ? surface_.project_to_sharp_edges(middle) : surface_.project(middle);
    // If the surface is at the limit of the tolerance, the new vertex is put so that it does not change the surface.
    for (const auto& [place, rule] : {std::pair(p, Rule::Any), std::pair(in_single(middle), Rule::Same)}) {
        const int v = add_vertex(place, halvings);
        if (attempt(split_edge(mesh_, a, b, v), rule)) {
            ++counts.splits;
            swap_around(v);
            return true;
        }
        forget_last_vertex();
    }
    return false;
}

Vec3 Improver::on_a_shell(int a, int b) const {
    const auto is_apex = [&](int v, int other) {
        const Vec3 along = mesh_.point(other) - mesh_.point(v);
        const std::vector<int>& ends = mesh_.sharp_neighbours(v);
        return std::any_of(ends.begin(), ends.end(), [&](int w) {
            return w != other && angle_between(along, mesh_.point(w) - mesh_.point(v)) < ImproveTuning::kNarrowEdges;
        });
    };
    const bool at_a = is_apex(a, b);
    const Vec3& p = mesh_.point(a);
    const Vec3& q = mesh_.point(b);
    if (at_a == is_apex(b, a)) {
        return 0.5 * (p + q);
    }
    const double length = (q - p).norm();
    // Fraction of the length, 0.35 to 0.71.
    const double shell = std::exp2(std::round(std::log2(0.5 * length))) / length;
    return at_a ? Vec3(p + shell * (q - p)) : Vec3(q + shell * (p - q));
}

int Improver::add_vertex(const Vec3& point, int halvings) {
    halvings_.push_back(halvings);
    changed_.push_back(now_);
    around_.push_back(now_);
    worst_.emplace_back(0, 0.0);
    moved_.push_back(0);
    return mesh_.add_vertex(point);
}

void Improver::forget_last_vertex() {
    mesh_.forget_last_vertex();
    halvings_.pop_back();
    changed_.pop_back();
    around_.pop_back();
    worst_.pop_back();
    moved_.pop_back();
}

void Improver::swap_around(int v) {
    std::deque<std::pair<int, int>> edges;
    const auto add_edges = [&](const Triangle& c) {
        for (std::size_t i = 0; i < 3; ++i) {
            edges.emplace_back(c[i], c[(i + 1) % 3]);
        }
    };
    for (const int t : mesh_.star(v)) {
        add_edges(mesh_.triangle(t));
    }
    // Each swap improves the worst angle of its two triangles, so that swaps end by themselves; the limit is for
    // safety.
    for (int steps = 0; !edges.empty() && steps < 400; ++steps) {
        const auto [a, b] = edges.front();
        edges.pop_front();
        if (mesh_.around_edge(a, b).empty()) {
            continue;
        }
        const auto change = swap_edge(mesh_, a, b);
        if (change && attempt(*change, Rule::Better)) {
            ++counts.flips;
            std::for_each(change->added.begin(), change->added.end(), add_edges);
        }
    }
}

bool Improver::attempt(const LocalOperation& change, Rule rule, const std::vector<Vec3>& leaving) {
    std::vector<std::vector<Vec3>> taken;
    const bool same = rule == Rule::Same;
    const double most = same ? std::numeric_limits<double>::infinity() : tolerance_;
    if (!good_enough(change, rule) || reaches_frozen(change) || !(same || near_enough(change)) ||
        !hand_over(change, leaving, most, taken)) {
        return false;
    }
    make(change, std::move(taken));
    return true;
}

void Improver::make(const LocalOperation& change, std::vector<std::vector<Vec3>> taken) {
    for (const int t : change.removed) {
        witnesses_[t].clear();
    }
    for (const Triangle& t : change.added) {
        angles_.push_back(smallest_angle(t));
        mended_.push_back(0);
    }
    mesh_.apply(change);
    note_changed(change);
    witnesses_.insert(witnesses_.end(), std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end()));
}

bool Improver::reaches_frozen(const LocalOperation& change) const {
    if (frozen_ == nullptr) {
        return false;
    }
    const auto reaches = [&](const Triangle& t) {
        Box box;
        for (const Vec3& p : mesh_.corners(t)) {
            box.add(p);
        }
        bool found = false;
        frozen_->for_each_in_box(box, [&](std::int32_t) { return !(found = true); });
        return found;
    };
    return std::any_of(change.removed.begin(), change.removed.end(),
                       [&](int t) { return reaches(mesh_.triangle(t)); }) ||
           std::any_of(change.added.begin(), change.added.end(), reaches);
}

bool Improver::good_enough(const LocalOperation& change, Rule rule) const {
    double least = 0.0;
    if (rule == Rule::Better) {
        double before = 180.0;
        for (const int t : change.removed) {
            before = std::min(before, angles_[t]);
        }
        least = before + ImproveTuning::kLeastAngleGain;
    }
    return std::all_of(change.added.begin(), change.added.end(),
                       [&](const Triangle& t) { return smallest_angle(t) > least; });
}

bool Improver::near_enough(const LocalOperation& change) const {
    for (const Triangle& t : change.added) {
        const std::array<Vec3, 3> p = mesh_.corners(t);
        const Vec3 centre = (p[0] + p[1] + p[2]) / 3.0;
        const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
        const ReferenceSurface::SurfaceProjection foot = surface_.foot(centre);
        if (foot.distance > tolerance_ ||
            (foot.normal != Vec3::Zero() && normal.dot(foot.normal) < ImproveTuning::kSameSide)) {
            return false;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            if (!surface_.within(0.5 * (p[i] + p[(i + 1) % 3]), tolerance_)) {
                return false;
            }
        }
    }
    return std::all_of(change.sharp.begin(), change.sharp.end(), [&](const std::pair<int, int>& edge) {
        const Vec3 middle = 0.5 * (mesh_.point(edge.first) + mesh_.point(edge.second));
        return surface_.sharp_edges_within(middle, tolerance_);
    });
}

bool Improver::hand_over(const LocalOperation& change, const std::vector<Vec3>& leaving, double most,
                         std::vector<std::vector<Vec3>>& taken) const {
    taken.assign(change.added.size(), {});
    const auto give = [&](const Vec3& p) {
        double best = most;
        std::size_t nearest = change.added.size();
        for (std::size_t i = 0; i < change.added.size(); ++i) {
            const std::array<Vec3, 3> c = mesh_.corners(change.added[i]);
            const double distance = (mesh::nearest_on_triangle(p, c[0], c[1], c[2]) - p).norm();
            if (distance <= best) {
                best = distance;
                nearest = i;
            }
        }
        if (nearest < taken.size()) {
            taken[nearest].push_back(p);
        }
        return nearest < taken.size();
    };
    return std::all_of(change.removed.begin(), change.removed.end(),
                       [&](int t) { return std::all_of(witnesses_[t].begin(), witnesses_[t].end(), give); }) &&
           std::all_of(leaving.begin(), leaving.end(), give);
}

}  // namespace mq::improve
