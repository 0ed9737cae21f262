// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/edge_collapse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "contour/corner_lists.h"
#include "contour/quadric.h"
#include "contour/triangle_grid.h"
#include "contour/tuning.h"
#include "mesh/intersection/embedded_star.h"
#include "mesh/intersection/triangle_contact.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::contour {

namespace {

using mesh::Triangle;

/// The square of the longest side.
double longest_square(const std::array<Vec3, 3>& c) {
    return std::max({(c[1] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm(), (c[0] - c[2]).squaredNorm()});
}

/// Tangent of the smallest angle. @param area  twice that of the triangle
double smallest_tangent(const std::array<Vec3, 3>& c, double area) {
    double cosine = 0.0;  // the largest cosine of an angle, times the lengths of its two sides
    for (std::size_t k = 0; k < 3; ++k) {
        cosine = std::max(cosine, (c[(k + 1) % 3] - c[k]).dot(c[(k + 2) % 3] - c[k]));
    }
    return area / cosine;
}

Vec3 cross(const std::array<Vec3, 3>& c) {
    return (c[1] - c[0]).cross(c[2] - c[0]);
}

bool has(const Triangle& t, std::int32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

/// An edge of the surface.
struct Edge {
    enum class State : std::uint8_t {
        Waiting,    ///< in the queue
        Changed,    ///< in the queue; its cost is another one since
        Tried,      ///< not in the queue: it cannot collapse as the surface is around it now
        Impossible  ///< gone or fixed
    };
    std::int32_t a = -1;
    std::int32_t b = -1;
    double cost = 0.0;  ///< that it has in the queue
    State state = State::Impossible;
};

/// An edge in the queue.
struct Queued {
    double cost = 0.0;
    std::int32_t edge = -1;

    bool operator<(const Queued& o) const { return std::tie(o.cost, o.edge) < std::tie(cost, edge); }
};

/// An edge, and the place to which both of its ends would move.
struct Candidate {
    std::int32_t a = -1;  ///< stays
    std::int32_t b = -1;  ///< becomes the other one
    Vec3 place = Vec3::Zero();

    bool is_end(std::int32_t v) const { return v == a || v == b; }
    /// Whether a triangle vanishes with the edge: it has both ends.
    bool removes(const Triangle& t) const { return has(t, a) && has(t, b); }
};

class EdgeCollapse {
  public:
    EdgeCollapse(Contour& surface, const std::vector<Crossing>& crossings, const CollapseLimits& limits,
                 Progress& progress, double from)
        : surface_(surface),
          crossings_(crossings),
          limits_(limits),
          most_(limits.distance * limits.distance),
          progress_(progress),
          from_(from),
          pace_(progress),
          border_weight_(std::pow(limits.distance / limits.border, 2.0)),
          corners_(surface.triangles, surface.points.size()),
          edges_of_(surface.triangles.size()),
          stays_(surface.points.size()),
          on_border_(surface.points.size()),
          marks_(surface.points.size()),
          quadrics_(surface.points.size()),
          planes_(surface.triangles.size()),
          seen_(surface.triangles.size()) {
        for (std::size_t t = 0; t < limits.fixed.size(); ++t) {
            for (const std::int32_t v : surface.triangles[t]) {
                stays_[v] = static_cast<char>(stays_[v] | limits.fixed[t]);
            }
        }
    }

    void run() {
        prepare();
        assess_all();
        const auto first = static_cast<double>(queue_.size());
        while (!queue_.empty()) {
            pace_.step();
            // Collapses add candidates, so that the work left is unknown: the progress is the fraction of the first
            // queue that is done.
            advance(1.0 - 0.5 * static_cast<double>(queue_.size()) / first);
            const std::int32_t next = queue_.top().edge;
            queue_.pop();
            if (is_still_first(next)) {
                Edge& edge = edges_[next];
                edge.state = Edge::State::Tried;
                Candidate candidate = candidate_of(edge);
                if (keeps_links(candidate) && finds_place(candidate)) {
                    edge.state = Edge::State::Impossible;
                    collapse(candidate);
                }
            }
        }
        finish();
    }

  private:
    /// @param done  fraction of this work
    void advance(double done) { progress_.advance(from_ + (1.0 - from_) * done); }

    std::array<Vec3, 3> corners(const Triangle& t) const {
        return {surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]]};
    }
    void prepare() {
        double longest = 0.0;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            const std::array<Vec3, 3> c = corners(surface_.triangles[t]);
            const std::int32_t plane = surface_.plane[t];
            planes_[t] = plane >= 0 ? crossings_[plane].normal : Vec3(cross(c).normalized());
            Quadric of_plane;
            of_plane.add_plane(plane >= 0 ? crossings_[plane].on_input : c[0], planes_[t], 1.0);
            for (const std::int32_t v : surface_.triangles[t]) {
                quadrics_[v].add(of_plane);
            }
            longest = std::max(longest, longest_square(c));
        }
        grid_ = TriangleGrid(std::sqrt(longest));
        for (std::size_t t = 0; limits_.keeps_apart && t < surface_.triangles.size(); ++t) {
            grid_.add(static_cast<std::int32_t>(t), corners(surface_.triangles[t]));
        }
        edges_.reserve(surface_.triangles.size() * 3 / 2);
        for (std::int32_t t = 0; t < static_cast<std::int32_t>(surface_.triangles.size()); ++t) {
            for (int k = 0; k < 3; ++k) {
                add_edge(t, k);
            }
        }
        for (std::size_t v = 0; v < surface_.points.size(); ++v) {
            find_border_at(static_cast<std::int32_t>(v));
        }
    }
    /// Numbers an edge of a triangle, after corner k, unless it has its number from the triangle beyond it.
    void add_edge(std::int32_t t, int k) {
        const std::int32_t a = surface_.triangles[t][k];
        const std::int32_t b = surface_.triangles[t][(k + 1) % 3];
        const std::int32_t beyond = beyond_edge(b, a);
        if (beyond >= 0 && beyond / 3 < t) {
            edges_of_[t][k] = edges_of_[beyond / 3][beyond % 3];
            return;
        }
        edges_of_[t][k] = static_cast<std::int32_t>(edges_.size());
        edges_.push_back({a, b});
        // A block ends at edges of one triangle, which are fixed.
        if (beyond >= 0 && surface_.patch[t] != surface_.patch[beyond / 3]) {
            keep_border(a, b, {t, beyond / 3});
        }
    }
    /// The corner from which an edge runs on from a to b; -1: none.
    std::int32_t beyond_edge(std::int32_t a, std::int32_t b) const {
        for (const std::int32_t corner : corners_.at(a)) {
            if (surface_.triangles[corner / 3][(corner + 1) % 3 == 0 ? 0 : corner % 3 + 1] == b) {
                return corner;
            }
        }
        return -1;
    }
    void find_border_at(std::int32_t v) {
        on_border_[v] = 0;
        for (const std::int32_t corner : corners_.at(v)) {
            on_border_[v] |=
                static_cast<char>(surface_.patch[corner / 3] != surface_.patch[*corners_.at(v).begin() / 3]);
        }
    }
    bool is_border(std::int32_t a, std::int32_t b) const {
        const std::int32_t one = beyond_edge(a, b);
        const std::int32_t two = beyond_edge(b, a);
        return one >= 0 && two >= 0 && surface_.patch[one / 3] != surface_.patch[two / 3];
    }
    /// Adds planes along a border edge that are perpendicular to the surface, so that the border does not shift across
    /// it.
    void keep_border(std::int32_t a, std::int32_t b, const std::array<std::int32_t, 2>& triangles) {
        const Vec3 along = surface_.points[b] - surface_.points[a];
        for (const std::int32_t t : triangles) {
            const Vec3 across = along.cross(planes_[t]);
            if (across.squaredNorm() > 0.0) {
                quadrics_[a].add_plane(surface_.points[a], across.normalized(), border_weight_);
                quadrics_[b].add_plane(surface_.points[a], across.normalized(), border_weight_);
            }
        }
    }

    void assess_all() {
        double done = 0.0;
        std::vector<Queued> all;
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            advance(0.5 * done++ / static_cast<double>(edges_.size()));
            if (assess(edges_[e])) {
                all.push_back({edges_[e].cost, static_cast<std::int32_t>(e)});
            }
        }
        queue_ = std::priority_queue<Queued>(std::less<Queued>(), std::move(all));
    }
    /// Finds the cost of an edge. @return whether its ends may be merged in one place
    bool assess(Edge& edge) const {
        edge.state = Edge::State::Impossible;
        const Candidate candidate = candidate_of(edge);
        const std::array<int, 2> held{hold(candidate.a), hold(candidate.b)};
        if (held[1] == 2) {
            return false;
        }
        edge.state = Edge::State::Tried;
        edge.cost = std::numeric_limits<double>::infinity();
        if (held[0] > 0 && held[1] > 0 && !is_border(edge.a, edge.b)) {
            return false;
        }
        Quadric both = quadrics_[candidate.a];
        both.add(quadrics_[candidate.b]);
        const double cost = std::max(0.0, both.at(best_place(candidate.a, candidate.b, held, both)));
        // In a plane all costs are nearly 0: there short edges come first.
        constexpr double kByLength = 1e-2;
        edge.cost = cost + kByLength * (surface_.points[edge.b] - surface_.points[edge.a]).squaredNorm();
        if (cost > most_) {
            return false;
        }
        edge.state = Edge::State::Waiting;
        return true;
    }
    Candidate candidate_of(const Edge& edge) const {
        const auto [a, b] = std::minmax(edge.a, edge.b);
        return stays_[b] != 0 ? Candidate{b, a} : Candidate{a, b};
    }
    /// Whether an edge from the queue is to be collapsed now. If its cost has changed, it comes again later: costs
    /// nearly always rise.
    bool is_still_first(std::int32_t e) {
        Edge& edge = edges_[e];
        if (edge.state != Edge::State::Changed) {
            return edge.state == Edge::State::Waiting;
        }
        if (!assess(edge)) {
            return false;
        }
        if (queue_.empty() || !(Queued{edge.cost, e} < queue_.top())) {
            return true;
        }
        queue_.push({edge.cost, e});
        return false;
    }
    /// The best place for both ends of an edge.
    /// @param held  see hold(), by end
    /// @param both  the sum of their quadrics
    Vec3 best_place(std::int32_t a, std::int32_t b, const std::array<int, 2>& held, const Quadric& both) const {
        const Vec3& p = surface_.points[a];
        const Vec3& q = surface_.points[b];
        const Vec3 place = held[0] == held[1] ? Vec3(0.5 * (p + q)) : held[0] > held[1] ? p : q;
        // What lies on all planes already is as good as any other place.
        constexpr double kOnPlanes = 1e-6;  // a fraction of the largest squared distance
        if (stays_[a] != 0 || both.at(place) <= kOnPlanes * most_) {
            return to_single(place);
        }
        const Vec3 best = to_single(both.least(place, ContourTuning::kFlatShare));
        // The least point of a nearly singular quadric may be anywhere.
        return (best - place).squaredNorm() <= (q - p).squaredNorm() ? best : to_single(place);
    }
    /// The constraint on a vertex: 2 fixed by a triangle, 1 on a border between patches, 0 none.
    int hold(std::int32_t v) const { return stays_[v] != 0 ? 2 : on_border_[v] != 0 ? 1 : 0; }

    /// Whether the surface stays 2-manifold, and is more than a tetrahedron: only the vertices beside the edge are
    /// joined to both of its ends (link condition).
    bool keeps_links(const Candidate& edge) {
        constexpr std::size_t kOfTetrahedron = 6;  // triangles at both ends
        const std::uint32_t joined = next_mark_;
        const std::uint32_t beside = next_mark_ + 1;
        next_mark_ += 2;
        std::size_t count = 0;
        for (const std::int32_t corner : corners_.at(edge.a)) {
            const Triangle& c = surface_.triangles[corner / 3];
            ++count;
            for (const std::int32_t v : c) {
                if (edge.removes(c) && !edge.is_end(v) && std::exchange(marks_[v], beside) == beside) {
                    return false;  // two triangles with the same vertices
                }
                marks_[v] = std::max(marks_[v], joined);
            }
        }
        for (const std::int32_t corner : corners_.at(edge.b)) {
            const Triangle& c = surface_.triangles[corner / 3];
            ++count;
            for (const std::int32_t v : c) {
                if (!edge.is_end(v) && marks_[v] == joined) {
                    return false;
                }
            }
        }
        return count > kOfTetrahedron;
    }

    /// Tries the best place and the places of both ends, and takes the first at which the surface stays sound.
    bool finds_place(Candidate& edge) {
        Quadric both = quadrics_[edge.a];
        both.add(quadrics_[edge.b]);
        const std::array<int, 2> held{hold(edge.a), hold(edge.b)};
        const std::array<Vec3, 3> places{best_place(edge.a, edge.b, held, both), surface_.points[edge.a],
                                         surface_.points[edge.b]};
        for (std::size_t k = 0; k < 3; ++k) {
            // The place of an end is not tried if the other end is held more; the best place is not tried if an end is
            // fixed.
            const bool leaves = k == 0 ? held[0] == 2 && places[0] != places[1] : held[k - 1] < held[2 - k];
            edge.place = places[k];
            if (!leaves && both.at(edge.place) <= most_ && limits_.within.contains(edge.place) && keeps_shape(edge) &&
                keeps_points(edge) && (!limits_.keeps_apart || keeps_apart(edge)) && is_accepted(edge)) {
                return true;
            }
        }
        return false;
    }

    /// Visits the triangles at one end or both, each once.
    template <typename Visit>
    bool all_at(const Candidate& edge, const Visit& visit) const {
        for (const std::int32_t corner : corners_.at(edge.a)) {
            if (!visit(corner / 3)) {
                return false;
            }
        }
        for (const std::int32_t corner : corners_.at(edge.b)) {
            if (!has(surface_.triangles[corner / 3], edge.a) && !visit(corner / 3)) {
                return false;
            }
        }
        return true;
    }
    /// Visits the triangles that stay, with both ends at the new place: visit(triangle, its new corners).
    template <typename Visit>
    bool all_of_moved(const Candidate& edge, const Visit& visit) const {
        return all_at(edge, [&](std::int32_t t) {
            const Triangle& c = surface_.triangles[t];
            return edge.removes(c) || visit(t, corners_at(c, edge));
        });
    }

    /// Whether no triangle turns away from its plane, becomes thinner than all triangles at the edge are, or gets a
    /// side that is too long.
    bool keeps_shape(const Candidate& edge) const {
        std::optional<double> thinnest;
        return all_of_moved(edge, [&](std::int32_t t, const std::array<Vec3, 3>& moved) {
            const Vec3 now = cross(moved);
            const double length = now.norm();
            const double ahead = now.dot(planes_[t]);
            if (!(length > 0.0) || longest_square(moved) > limits_.longest * limits_.longest ||
                (ahead < ContourTuning::kTurn * length && ahead < turn(t) * length)) {
                return false;
            }
            const double tangent = smallest_tangent(moved, length);
            if (tangent >= ContourTuning::kThinTangent) {
                return true;
            }
            thinnest = thinnest ? thinnest : thinnest_at(edge);
            return tangent >= *thinnest;
        });
    }
    /// The cosine between a triangle's normal and that of its plane.
    double turn(std::int32_t t) const { return cross(corners(surface_.triangles[t])).normalized().dot(planes_[t]); }
    /// The tangent of the smallest angle of all triangles at an edge.
    double thinnest_at(const Candidate& edge) const {
        double least = std::numeric_limits<double>::infinity();
        all_at(edge, [&](std::int32_t t) {
            const std::array<Vec3, 3> c = corners(surface_.triangles[t]);
            least = std::min(least, smallest_tangent(c, cross(c).norm()));
            return true;
        });
        return least;
    }

    /// Whether no moved triangle meets another one.
    bool keeps_apart(const Candidate& edge) {
        // The grid contains the moved triangles, too, at their old places: their new boxes come first in the list.
        near_.clear();
        ++round_;
        all_at(edge, [&](std::int32_t t) {
            seen_[t] = round_;
            return true;
        });
        all_of_moved(edge, [&](std::int32_t t, const std::array<Vec3, 3>&) {
            near_.emplace_back(t, box_of(t, edge));
            return true;
        });
        const std::size_t moved = near_.size();
        for (std::size_t i = 0; i < moved; ++i) {
            const Triangle own = surface_.triangles[near_[i].first];
            grid_.all_near(corners_at(own, edge), [&](std::int32_t other) {
                if (seen_[other] != round_) {
                    seen_[other] = round_;
                    near_.emplace_back(other, box_of(other, edge));
                }
                return true;
            });
        }
        find_embedded(edge, moved);
        for (std::size_t i = 0; i < moved; ++i) {
            for (std::size_t j = i + 1; j < near_.size(); ++j) {
                if (near_[i].second.meets(near_[j].second) && !apart(near_[i].first, near_[j].first, edge)) {
                    return false;
                }
            }
        }
        return true;
    }
    /// Finds the vertices of the moved triangles whose stars are embedded with both ends at the new place: two
    /// triangles at such a vertex do not meet.
    void find_embedded(const Candidate& edge, std::size_t moved) {
        embedded_.clear();
        for (std::size_t i = 0; i < moved; ++i) {
            for (const std::int32_t v : renamed(surface_.triangles[near_[i].first], edge, edge.a)) {
                if (std::none_of(embedded_.begin(), embedded_.end(), [&](const auto& e) { return e.first == v; })) {
                    embedded_.emplace_back(v, is_embedded(v, edge));
                }
            }
        }
    }
    bool is_embedded(std::int32_t v, const Candidate& edge) {
        star_.clear();
        const auto place = [&](std::int32_t w) { return w == edge.a ? edge.place : surface_.points[w]; };
        const auto add = [&](std::int32_t t) {
            if (!edge.removes(surface_.triangles[t])) {
                const Triangle c = renamed(surface_.triangles[t], edge, edge.a);
                const std::size_t k = c[0] == v ? 0 : c[1] == v ? 1 : 2;
                const std::int32_t from = c[(k + 1) % 3];
                const std::int32_t to = c[(k + 2) % 3];
                star_.push_back({from, to, place(from) - place(v), place(to) - place(v)});
            }
            return true;
        };
        if (v == edge.a) {
            all_at(edge, add);
        } else {
            for (const std::int32_t corner : corners_.at(v)) {
                add(corner / 3);
            }
        }
        return mesh::embedded_star(star_.data(), star_.size());
    }
    bool is_fixed(std::int32_t t) const { return !limits_.fixed.empty() && limits_.fixed[t] != 0; }
    /// Whether a triangle at an end stays where it is.
    bool is_unmoved(std::int32_t t, const Candidate& edge) const {
        const Triangle& c = surface_.triangles[t];
        return std::all_of(c.begin(), c.end(),
                           [&](std::int32_t v) { return !edge.is_end(v) || surface_.points[v] == edge.place; });
    }
    /// Whether the limits accept all moved triangles.
    bool is_accepted(const Candidate& edge) const {
        return !limits_.accepts || all_of_moved(edge, [&](std::int32_t t, const std::array<Vec3, 3>& moved) {
            const Triangle& c = surface_.triangles[t];
            const std::size_t k = edge.is_end(c[0]) ? 0 : edge.is_end(c[1]) ? 1 : 2;
            return is_unmoved(t, edge) ||
                   limits_.accepts({moved[k], moved[(k + 1) % 3], moved[(k + 2) % 3]}, surface_.source[t]);
        });
    }
    /// Whether the kept points of the moved triangles and of those that vanish are near triangles of their patches,
    /// which `handed_` has afterwards.
    bool keeps_points(const Candidate& edge) {
        handed_.clear();
        if (surface_.kept.empty()) {
            return true;
        }
        takers_.clear();
        all_of_moved(edge, [&](std::int32_t t, const std::array<Vec3, 3>& moved) {
            if (!is_fixed(t)) {
                takers_.emplace_back(t, moved);
            }
            return true;
        });
        const double most = limits_.kept_distance * limits_.kept_distance;
        return all_at(edge, [&](std::int32_t t) {
            if (is_fixed(t) || (!edge.removes(surface_.triangles[t]) && is_unmoved(t, edge))) {
                return true;
            }
            return std::all_of(surface_.kept[t].begin(), surface_.kept[t].end(), [&](std::int32_t point) {
                const Vec3& p = (*limits_.kept_points)[point];
                double least = std::numeric_limits<double>::infinity();
                std::int32_t taker = -1;
                for (const auto& [other, c] : takers_) {
                    const double squared = surface_.patch[other] != surface_.patch[t]
                                               ? std::numeric_limits<double>::infinity()
                                               : (mesh::nearest_on_triangle(p, c[0], c[1], c[2]) - p).squaredNorm();
                    if (squared < least) {
                        least = squared;
                        taker = other;
                    }
                }
                handed_.emplace_back(point, taker);
                return least <= most;
            });
        });
    }
    void hand_over(const Candidate& edge) {
        if (surface_.kept.empty()) {
            return;
        }
        all_at(edge, [&](std::int32_t t) {
            if (!is_fixed(t) && (edge.removes(surface_.triangles[t]) || !is_unmoved(t, edge))) {
                surface_.kept[t].clear();
            }
            return true;
        });
        for (const auto& [point, taker] : handed_) {
            surface_.kept[taker].push_back(point);
        }
    }
    /// The corners of a triangle with the ends at the new place.
    std::array<Vec3, 3> corners_at(const Triangle& c, const Candidate& edge) const {
        std::array<Vec3, 3> moved = corners(c);
        for (int k = 0; k < 3; ++k) {
            moved[k] = edge.is_end(c[k]) ? edge.place : moved[k];
        }
        return moved;
    }
    Box box_of(std::int32_t t, const Candidate& edge) const {
        Box box;
        for (const std::int32_t v : surface_.triangles[t]) {
            box.add(edge.is_end(v) ? edge.place : surface_.points[v]);
        }
        return box;
    }
    /// Whether two triangles are apart with both ends of the edge at the new place.
    bool apart(std::int32_t t, std::int32_t other, const Candidate& edge) {
        const Triangle first = renamed(surface_.triangles[t], edge, edge.a);
        const Triangle second = renamed(surface_.triangles[other], edge, edge.a);
        bool shared = false;
        for (const std::int32_t v : first) {
            if (has(second, v)) {
                shared = true;
                const auto at = std::find_if(embedded_.begin(), embedded_.end(),
                                             [&](const auto& entry) { return entry.first == v; });
                if (at->second) {
                    return true;
                }
            }
        }
        if (!shared && mesh::certainly_apart(corners_at(first, edge), corners_at(second, edge))) {
            return true;
        }
        std::vector<Vec3>& points = of_pair_;
        points.clear();
        std::array<Triangle, 2> named{first, second};
        std::array<std::int32_t, 6> known{};
        for (Triangle& triangle : named) {
            for (std::int32_t& v : triangle) {
                const auto end = known.begin() + static_cast<std::ptrdiff_t>(points.size());
                const auto at = std::find(known.begin(), end, v);
                if (at == end) {
                    *end = v;
                    points.push_back(v == edge.a ? edge.place : surface_.points[v]);
                }
                v = static_cast<std::int32_t>(at - known.begin());
            }
        }
        return mesh::contact(points, named[0], named[1]) == mesh::Contact::None;
    }
    static Triangle renamed(Triangle t, const Candidate& edge, std::int32_t v) {
        for (std::int32_t& corner : t) {
            corner = edge.is_end(corner) ? v : corner;
        }
        return t;
    }

    /// Moves both ends of an edge to the new place, and merges them.
    void collapse(const Candidate& edge) {
        hand_over(edge);
        if (limits_.keeps_apart) {
            all_at(edge, [&](std::int32_t t) {
                grid_.remove(t, corners(surface_.triangles[t]));
                return true;
            });
        }
        merge_ends(edge);
        surface_.points[edge.a] = edge.place;
        quadrics_[edge.a].add(quadrics_[edge.b]);
        find_border_at(edge.a);
        for (const std::int32_t corner : corners_.at(edge.a)) {
            const std::int32_t t = corner / 3;
            if (limits_.keeps_apart) {
                grid_.add(t, corners(surface_.triangles[t]));
            }
            change(edges_of_[t][corner % 3]);
            change(edges_of_[t][(corner + 2) % 3]);
            change(edges_of_[t][(corner + 1) % 3]);
        }
    }
    /// Removes the triangles at an edge; the others at its second end get the first one in its place.
    void merge_ends(const Candidate& edge) {
        gone_.clear();
        for (const std::int32_t corner : corners_.at(edge.b)) {
            if (has(surface_.triangles[corner / 3], edge.a)) {
                gone_.push_back(corner);
            }
        }
        for (const std::int32_t corner : gone_) {
            remove_triangle(corner / 3, corner % 3, edge);
        }
        for (const std::int32_t corner : corners_.at(edge.b)) {
            const std::int32_t t = corner / 3;
            surface_.triangles[t][corner % 3] = edge.a;
            for (const int k : {corner % 3, (corner + 2) % 3}) {
                Edge& its = edges_[edges_of_[t][k]];
                its.a = its.a == edge.b ? edge.a : its.a;
                its.b = its.b == edge.b ? edge.a : its.b;
            }
        }
        corners_.append(edge.a, edge.b);
    }
    /// Removes a triangle of the edge. Its other two edges become one.
    /// @param k  its corner at the end that vanishes
    void remove_triangle(std::int32_t t, int k, const Candidate& edge) {
        const Triangle c = surface_.triangles[t];
        const int at_a = c[(k + 1) % 3] == edge.a ? (k + 1) % 3 : (k + 2) % 3;
        const int beside = 3 - k - at_a;
        const bool forward = at_a == (k + 1) % 3;  // the edge runs from b to a
        const std::int32_t stays = edges_of_[t][forward ? at_a : beside];
        const std::int32_t goes = edges_of_[t][forward ? beside : k];
        const std::int32_t beyond = forward ? beyond_edge(edge.b, c[beside]) : beyond_edge(c[beside], edge.b);
        edges_[goes].state = Edge::State::Impossible;
        if (beyond >= 0) {
            edges_of_[beyond / 3][beyond % 3] = stays;
        }
        for (const int corner : {k, at_a, beside}) {
            corners_.remove(3 * t + corner, c[corner]);
        }
        surface_.triangles[t] = {-1, -1, -1};
        find_border_at(c[beside]);
    }
    /// What is known of an edge holds no more.
    void change(std::int32_t e) {
        Edge& edge = edges_[e];
        if (edge.state == Edge::State::Tried) {
            queue_.push({edge.cost, e});
        }
        edge.state = edge.state == Edge::State::Impossible ? edge.state : Edge::State::Changed;
    }

    /// Removes vertices and triangles that are gone.
    void finish() {
        std::vector<std::int32_t> index(surface_.points.size(), -1);
        std::size_t count = 0;
        for (std::size_t v = 0; v < surface_.points.size(); ++v) {
            if (!corners_.empty(static_cast<std::int32_t>(v))) {
                index[v] = static_cast<std::int32_t>(count);
                surface_.points[count++] = surface_.points[v];
            }
        }
        surface_.points.resize(count);
        std::size_t left = 0;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            const Triangle c = surface_.triangles[t];
            if (c[0] >= 0) {
                surface_.triangles[left] = {index[c[0]], index[c[1]], index[c[2]]};
                surface_.source[left] = surface_.source[t];
                surface_.patch[left] = surface_.patch[t];
                surface_.plane[left] = surface_.plane[t];
                if (!surface_.kept.empty()) {
                    std::swap(surface_.kept[left], surface_.kept[t]);
                }
                ++left;
            }
        }
        surface_.triangles.resize(left);
        surface_.source.resize(left);
        surface_.patch.resize(left);
        surface_.plane.resize(left);
        surface_.kept.resize(surface_.kept.empty() ? 0 : left);
    }

    Contour& surface_;
    const std::vector<Crossing>& crossings_;
    const CollapseLimits& limits_;
    double most_;  ///< largest squared distance
    Progress& progress_;
    double from_;
    CancelPace pace_;
    double border_weight_;
    CornerLists corners_;
    std::vector<Edge> edges_;
    std::vector<std::array<std::int32_t, 3>> edges_of_;  ///< by triangle: the edge after each of its corners
    std::vector<char> stays_;                            ///< by vertex: whether a fixed triangle has it
    std::vector<char> on_border_;                        ///< by vertex: whether its triangles are of several patches
    std::vector<std::uint32_t> marks_;                   ///< by vertex, for keeps_links
    std::uint32_t next_mark_ = 1;
    std::vector<Quadric> quadrics_;
    std::vector<Vec3> planes_;  ///< normal of the plane that each triangle stands for
    TriangleGrid grid_{1.0};
    std::priority_queue<Queued> queue_;
    // Buffers for the tests of one collapse.
    std::vector<std::int32_t> gone_;                  ///< corners of triangles that vanish
    std::vector<std::pair<std::int32_t, Box>> near_;  ///< moved triangles, then those near them, with their boxes
    std::vector<std::uint32_t> seen_;                 ///< by triangle: the round in which it came into near_
    std::uint32_t round_ = 0;
    std::vector<std::pair<std::int32_t, bool>> embedded_;  ///< vertices of moved triangles, whether their star is
    std::vector<mesh::StarSector> star_;                   ///< the star under test
    std::vector<Vec3> of_pair_;                            ///< points of two triangles that are tested
    std::vector<std::pair<std::int32_t, std::array<Vec3, 3>>> takers_;  ///< moved triangles that kept points may go to
    std::vector<std::pair<std::int32_t, std::int32_t>> handed_;         ///< kept points, and the triangle of each
};

}  // namespace

void collapse_edges(Contour& surface, const std::vector<Crossing>& crossings, const CollapseLimits& limits,
                    Progress& progress, double from) {
    EdgeCollapse(surface, crossings, limits, progress, from).run();
}

}  // namespace mq::contour
