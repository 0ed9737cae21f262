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

#include "contour/edge_mesh.h"
#include "contour/quadric.h"
#include "contour/triangle_grid.h"
#include "contour/triangle_shape.h"
#include "contour/tuning.h"
#include "mesh/intersection/embedded_star.h"
#include "mesh/intersection/triangle_contact.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::contour {

namespace {

using mesh::Triangle;

/// What is known of an edge of the surface.
struct Assessed {
    enum class State : std::uint8_t {
        Waiting,    ///< in the queue
        Changed,    ///< in the queue; its cost is another one since
        Tried,      ///< not in the queue: it cannot collapse as the surface is around it now
        Impossible  ///< gone or fixed
    };
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
          edges_(surface.triangles, surface.points.size()),
          assessed_(edges_.edge_count()),
          stays_(surface.points.size()),
          on_border_(surface.points.size()),
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
                assessed_[next].state = Assessed::State::Tried;
                Candidate edge = candidate_of(next);
                if (edges_.keeps_links(edge.a, edge.b) && finds_place(edge)) {
                    assessed_[next].state = Assessed::State::Impossible;
                    collapse(edge);
                }
            }
        }
        remove_gone(surface_);
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
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            if (is_tested(corners(surface_.triangles[t]))) {
                grid_.add(static_cast<std::int32_t>(t), corners(surface_.triangles[t]));
            }
        }
        for (std::size_t v = 0; v < surface_.points.size(); ++v) {
            find_border_at(static_cast<std::int32_t>(v));
        }
        for (std::size_t e = 0; e < edges_.edge_count(); ++e) {
            keep_border(static_cast<std::int32_t>(e));
        }
    }
    void find_border_at(std::int32_t v) {
        on_border_[v] = 0;
        for (const std::int32_t corner : edges_.corners_at(v)) {
            const std::int32_t first = *edges_.corners_at(v).begin();
            on_border_[v] |= static_cast<char>(surface_.patch[corner / 3] != surface_.patch[first / 3]);
        }
    }
    /// The triangles on both sides of an edge; -1: it has one only, as edges at which a block ends, which are fixed.
    std::array<std::int32_t, 2> beside(std::int32_t e) const {
        const auto [a, b] = edges_.ends(e);
        const std::int32_t one = edges_.corner_of(a, b);
        const std::int32_t two = edges_.corner_of(b, a);
        return {one < 0 ? -1 : one / 3, two < 0 ? -1 : two / 3};
    }
    bool is_border(std::int32_t e) const {
        if (on_border_[edges_.ends(e)[0]] == 0 || on_border_[edges_.ends(e)[1]] == 0) {
            return false;
        }
        const auto [one, two] = beside(e);
        return one >= 0 && two >= 0 && surface_.patch[one] != surface_.patch[two];
    }
    /// Adds planes along a border edge that are perpendicular to the surface, so that the border does not shift across
    /// it.
    void keep_border(std::int32_t e) {
        if (!is_border(e)) {
            return;
        }
        const auto [a, b] = edges_.ends(e);
        const Vec3 along = surface_.points[b] - surface_.points[a];
        for (const std::int32_t t : beside(e)) {
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
        for (std::int32_t e = 0; e < static_cast<std::int32_t>(edges_.edge_count()); ++e) {
            advance(0.5 * done++ / static_cast<double>(edges_.edge_count()));
            if (assess(e)) {
                all.push_back({assessed_[e].cost, e});
            }
        }
        queue_ = std::priority_queue<Queued>(std::less<Queued>(), std::move(all));
    }
    /// Finds the cost of an edge. @return whether its ends may be merged in one place
    bool assess(std::int32_t e) {
        Assessed& its = assessed_[e];
        const Candidate edge = candidate_of(e);
        const std::array<int, 2> held{hold(edge.a), hold(edge.b)};
        its = {std::numeric_limits<double>::infinity(),
               held[1] == 2 ? Assessed::State::Impossible : Assessed::State::Tried};
        if (held[1] == 2 || (held[0] > 0 && held[1] > 0 && !is_border(e))) {
            return false;
        }
        Quadric both = quadrics_[edge.a];
        both.add(quadrics_[edge.b]);
        const double cost = std::max(0.0, both.at(best_place(edge.a, edge.b, held, both)));
        // In a plane all costs are nearly 0: there short edges come first.
        constexpr double kByLength = 1e-2;
        its.cost = cost + kByLength * (surface_.points[edge.b] - surface_.points[edge.a]).squaredNorm();
        its.state = cost <= most_ ? Assessed::State::Waiting : Assessed::State::Tried;
        return cost <= most_;
    }
    Candidate candidate_of(std::int32_t e) const {
        const auto [a, b] = std::minmax(edges_.ends(e)[0], edges_.ends(e)[1]);
        return stays_[b] != 0 ? Candidate{b, a} : Candidate{a, b};
    }
    /// Whether an edge from the queue is to be collapsed now. If its cost has changed, it comes again later: costs
    /// nearly always rise.
    bool is_still_first(std::int32_t e) {
        if (assessed_[e].state != Assessed::State::Changed) {
            return assessed_[e].state == Assessed::State::Waiting;
        }
        if (!assess(e)) {
            return false;
        }
        const Queued again{assessed_[e].cost, e};
        if (queue_.empty() || !(again < queue_.top())) {
            return true;
        }
        queue_.push(again);
        return false;
    }
    /// What is known of an edge holds no more.
    void change(std::int32_t e) {
        Assessed& its = assessed_[e];
        if (its.state == Assessed::State::Tried) {
            queue_.push({its.cost, e});
        }
        its.state = its.state == Assessed::State::Impossible ? its.state : Assessed::State::Changed;
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
                keeps_points(edge) && keeps_apart(edge) && is_accepted(edge)) {
                return true;
            }
        }
        return false;
    }

    /// Visits the triangles at one end or both, each once.
    template <typename Visit>
    bool all_at(const Candidate& edge, const Visit& visit) const {
        for (const std::int32_t corner : edges_.corners_at(edge.a)) {
            if (!visit(corner / 3)) {
                return false;
            }
        }
        for (const std::int32_t corner : edges_.corners_at(edge.b)) {
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

    /// Whether a triangle is at a place where it must not meet others.
    bool is_tested(const std::array<Vec3, 3>& c) const {
        return std::any_of(limits_.tested.begin(), limits_.tested.end(),
                           [&](const Box& tested) { return tested.meets(box_of(c)); });
    }
    /// Whether no moved triangle meets another one.
    bool keeps_apart(const Candidate& edge) {
        if (limits_.tested.empty() ||
            all_of_moved(edge, [&](std::int32_t, const std::array<Vec3, 3>& moved) { return !is_tested(moved); })) {
            return true;
        }
        // The grid contains the moved triangles, too, at their old places: their new boxes come first in the list.
        near_.clear();
        ++round_;
        all_at(edge, [&](std::int32_t t) {
            seen_[t] = round_;
            return true;
        });
        all_of_moved(edge, [&](std::int32_t t, const std::array<Vec3, 3>&) {
            near_.emplace_back(t, box_at(t, edge));
            return true;
        });
        const std::size_t moved = near_.size();
        for (std::size_t i = 0; i < moved; ++i) {
            const Triangle own = surface_.triangles[near_[i].first];
            grid_.all_near(corners_at(own, edge), [&](std::int32_t other) {
                if (seen_[other] != round_) {
                    seen_[other] = round_;
                    near_.emplace_back(other, box_at(other, edge));
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
            for (const std::int32_t corner : edges_.corners_at(v)) {
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
    Box box_at(std::int32_t t, const Candidate& edge) const { return box_of(corners_at(surface_.triangles[t], edge)); }
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
        all_at(edge, [&](std::int32_t t) {
            if (const std::array<Vec3, 3> c = corners(surface_.triangles[t]); is_tested(c)) {
                grid_.remove(t, c);
            }
            return true;
        });
        const EdgeMesh::Merged& merged = edges_.merge(edge.a, edge.b);
        surface_.points[edge.a] = edge.place;
        quadrics_[edge.a].add(quadrics_[edge.b]);
        for (const std::int32_t e : merged.edges) {
            assessed_[e].state = Assessed::State::Impossible;
        }
        for (const std::int32_t v : merged.vertices) {
            find_border_at(v);
        }
        find_border_at(edge.a);
        for (const std::int32_t corner : edges_.corners_at(edge.a)) {
            const std::int32_t t = corner / 3;
            if (const std::array<Vec3, 3> c = corners(surface_.triangles[t]); is_tested(c)) {
                grid_.add(t, c);
            }
            for (int k = 0; k < 3; ++k) {
                change(edges_.edge_after(t, k));
            }
        }
    }

    Contour& surface_;
    const std::vector<Crossing>& crossings_;
    const CollapseLimits& limits_;
    double most_;  ///< largest squared distance
    Progress& progress_;
    double from_;
    CancelPace pace_;
    double border_weight_;
    EdgeMesh edges_;
    std::vector<Assessed> assessed_;  ///< by edge
    std::vector<char> stays_;         ///< by vertex: whether a fixed triangle has it
    std::vector<char> on_border_;     ///< by vertex: whether its triangles are of several patches
    std::vector<Quadric> quadrics_;
    std::vector<Vec3> planes_;  ///< normal of the plane that each triangle stands for
    TriangleGrid grid_{1.0};
    std::priority_queue<Queued> queue_;
    // Buffers for the tests of one collapse.
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
