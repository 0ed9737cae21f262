// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/edge_collapse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

#include "contour/quadric.h"
#include "contour/triangle_grid.h"
#include "contour/tuning.h"
#include "mesh/intersection/embedded_star.h"
#include "mesh/intersection/triangle_contact.h"
#include "mesh/intersection/triangle_distance.h"
#include "mesh/simplex_stars.h"

namespace mq::contour {

namespace {

using mesh::Triangle;

double longest_side(const std::array<Vec3, 3>& c) {
    return std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
}

/// Tangent of the smallest angle.
double smallest_tangent(const std::array<Vec3, 3>& c) {
    const double area = (c[1] - c[0]).cross(c[2] - c[0]).norm();
    double cosine = 0.0;  // the largest cosine of an angle, times the lengths of its two sides
    for (std::size_t k = 0; k < 3; ++k) {
        cosine = std::max(cosine, (c[(k + 1) % 3] - c[k]).dot(c[(k + 2) % 3] - c[k]));
    }
    return area / cosine;
}

bool has(const Triangle& t, std::int32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

/// An edge in the queue of candidates.
struct Queued {
    double cost = 0.0;
    std::int32_t a = -1;
    std::int32_t b = -1;
    std::int32_t age_a = 0;  ///< number of moves of each end when the edge was assessed
    std::int32_t age_b = 0;

    bool operator<(const Queued& o) const { return std::tie(o.cost, o.a, o.b) < std::tie(cost, a, b); }
};

/// An edge, and the place to which both of its ends would move.
struct Candidate {
    std::int32_t a = -1;
    std::int32_t b = -1;
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
          stars_(surface.points.size()),
          ages_(surface.points.size()),
          stays_(surface.points.size()),
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
            const Queued next = queue_.top();
            queue_.pop();
            Candidate edge{next.a, next.b};
            if (next.age_a == ages_[next.a] && next.age_b == ages_[next.b] && keeps_links(edge) && finds_place(edge)) {
                collapse(edge);
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
    Vec3 normal(const Triangle& t) const {
        const std::array<Vec3, 3> c = corners(t);
        return (c[1] - c[0]).cross(c[2] - c[0]).normalized();
    }

    void prepare() {
        double longest = 0.0;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            const Triangle& c = surface_.triangles[t];
            const std::int32_t plane = surface_.plane[t];
            planes_[t] = plane >= 0 ? crossings_[plane].normal : normal(c);
            stars_.add(static_cast<int>(t), c);
            const Vec3& on = plane >= 0 ? crossings_[plane].on_input : surface_.points[c[0]];
            for (int k = 0; k < 3; ++k) {
                quadrics_[c[k]].add_plane(on, planes_[t], 1.0);
                longest = std::max(longest, (surface_.points[c[k]] - surface_.points[c[(k + 1) % 3]]).norm());
            }
        }
        grid_ = TriangleGrid(longest);
        for (std::size_t t = 0; limits_.keeps_apart && t < surface_.triangles.size(); ++t) {
            grid_.add(static_cast<std::int32_t>(t), corners(surface_.triangles[t]));
        }
        for (const Triangle& c : surface_.triangles) {
            for (int k = 0; k < 3; ++k) {
                const std::int32_t a = c[k];
                const std::int32_t b = c[(k + 1) % 3];
                if (a < b) {
                    keep_border(a, b);
                }
            }
        }
    }

    bool is_border(std::int32_t a, std::int32_t b) const {
        const std::vector<int> two = stars_.of({a, b}, surface_.triangles);
        return surface_.patch[two[0]] != surface_.patch[two[1]];
    }
    bool on_border(std::int32_t v) const {
        return std::any_of(stars_[v].begin(), stars_[v].end(),
                           [&](std::int32_t t) { return surface_.patch[t] != surface_.patch[stars_[v][0]]; });
    }
    /// Adds planes along a border edge that are perpendicular to the surface, so that the border does not shift across
    /// it.
    void keep_border(std::int32_t a, std::int32_t b) {
        const double weight = std::pow(limits_.distance / limits_.border, 2.0);
        const std::vector<int> two = stars_.of({a, b}, surface_.triangles);
        const Vec3 along = surface_.points[b] - surface_.points[a];
        // A block ends at edges of one triangle, which are fixed.
        if (two.size() < 2 || surface_.patch[two[0]] == surface_.patch[two[1]] || along.squaredNorm() == 0.0) {
            return;
        }
        for (const std::int32_t t : two) {
            const Vec3 across = along.cross(planes_[t]);
            if (across.squaredNorm() > 0.0) {
                quadrics_[a].add_plane(surface_.points[a], across.normalized(), weight);
                quadrics_[b].add_plane(surface_.points[a], across.normalized(), weight);
            }
        }
    }

    void assess_all() {
        double done = 0.0;
        std::vector<Queued> all;
        for (const Triangle& c : surface_.triangles) {
            advance(0.5 * done++ / static_cast<double>(surface_.triangles.size()));
            for (int k = 0; k < 3; ++k) {
                if (c[k] < c[(k + 1) % 3]) {
                    assess(c[k], c[(k + 1) % 3], [&](const Queued& edge) { all.push_back(edge); });
                }
            }
        }
        queue_ = std::priority_queue<Queued>(std::less<Queued>(), std::move(all));
    }

    /// Adds the edge to the candidates if its ends may be merged in one place.
    template <typename Add>
    void assess(std::int32_t a, std::int32_t b, const Add& add) const {
        if (stays_[b] != 0) {
            std::swap(a, b);  // after the collapse the vertex has the index of the first end
        }
        const int hold_a = hold(a);
        const int hold_b = hold(b);
        if (stays_[b] != 0 || (hold_a > 0 && hold_b > 0 && !is_border(a, b))) {
            return;
        }
        Quadric both = quadrics_[a];
        both.add(quadrics_[b]);
        const double cost = std::max(0.0, both.at(best_place(a, b, {hold_a, hold_b}, both)));
        // In a plane all costs are nearly 0: there short edges come first.
        constexpr double kByLength = 1e-2;
        if (cost <= most_) {
            const double length = (surface_.points[b] - surface_.points[a]).squaredNorm();
            add({cost + kByLength * length, a, b, ages_[a], ages_[b]});
        }
    }
    /// The best place for both ends of an edge.
    /// @param held  see hold(), by end
    /// @param both  the sum of their quadrics
    Vec3 best_place(std::int32_t a, std::int32_t b, const std::array<int, 2>& held, const Quadric& both) const {
        const Vec3& p = surface_.points[a];
        const Vec3& q = surface_.points[b];
        const Vec3 place = held[0] == held[1] ? Vec3(0.5 * (p + q)) : held[0] > held[1] ? p : q;
        if (stays_[a] != 0) {
            return place;
        }
        const Vec3 best = to_single(both.least(place, ContourTuning::kFlatShare));
        // The least point of a nearly singular quadric may be anywhere.
        return (best - place).squaredNorm() <= (q - p).squaredNorm() ? best : to_single(place);
    }
    /// The constraint on a vertex: 2 fixed by a triangle, 1 on a border between patches, 0 none.
    int hold(std::int32_t v) const { return stays_[v] != 0 ? 2 : on_border(v) ? 1 : 0; }

    /// Whether the surface stays 2-manifold, and is more than a tetrahedron.
    bool keeps_links(const Candidate& edge) const {
        constexpr std::size_t kOfTetrahedron = 6;  // triangles at both ends
        return stars_[edge.a].size() + stars_[edge.b].size() > kOfTetrahedron &&
               stars_.link_condition(edge.a, edge.b, surface_.triangles);
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
            if (!leaves && both.at(edge.place) <= most_ && keeps_shape(edge) && keeps_within(edge) &&
                keeps_points(edge) && (!limits_.keeps_apart || keeps_apart(edge)) && is_accepted(edge)) {
                return true;
            }
        }
        return false;
    }

    /// Visits the triangles at one end or both, each once.
    template <typename Visit>
    bool all_at(const Candidate& edge, const Visit& visit) const {
        const auto is_new = [&](std::int32_t t) { return !has(surface_.triangles[t], edge.a); };
        return std::all_of(stars_[edge.a].begin(), stars_[edge.a].end(), visit) &&
               std::all_of(stars_[edge.b].begin(), stars_[edge.b].end(),
                           [&](std::int32_t t) { return !is_new(t) || visit(t); });
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
        double thinnest = ContourTuning::kThinTangent;
        all_at(edge, [&](std::int32_t t) {
            thinnest = std::min(thinnest, smallest_tangent(corners(surface_.triangles[t])));
            return true;
        });
        return all_of_moved(edge, [&](std::int32_t t, const std::array<Vec3, 3>& moved) {
            const Vec3 cross = (moved[1] - moved[0]).cross(moved[2] - moved[0]);
            const double length = cross.norm();
            const double before = normal(surface_.triangles[t]).dot(planes_[t]);
            return length > 0.0 && longest_side(moved) <= limits_.longest &&
                   cross.dot(planes_[t]) >= std::min(ContourTuning::kTurn, before) * length &&
                   smallest_tangent(moved) >= thinnest;
        });
    }

    /// Whether all moved triangles are in the box of the limits.
    bool keeps_within(const Candidate& edge) const {
        return all_of_moved(edge, [&](std::int32_t t, const std::array<Vec3, 3>& moved) {
            const bool is_fixed = !limits_.fixed.empty() && limits_.fixed[t] != 0;
            return is_fixed ||
                   std::all_of(moved.begin(), moved.end(), [&](const Vec3& p) { return limits_.within.contains(p); });
        });
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
            std::for_each(stars_[v].begin(), stars_[v].end(), add);
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

    /// Moves both ends of the edge to the new place, and merges them.
    void apply(const Candidate& edge) {
        std::vector<std::int32_t> star;
        all_at(edge, [&](std::int32_t t) {
            star.push_back(t);
            return true;
        });
        for (const std::int32_t t : star) {
            if (limits_.keeps_apart) {
                grid_.remove(t, corners(surface_.triangles[t]));
            }
        }
        surface_.points[edge.a] = edge.place;
        for (const std::int32_t t : star) {
            Triangle& c = surface_.triangles[t];
            stars_.remove(t, c);
            if (edge.removes(c)) {
                c = {-1, -1, -1};
            } else {
                c = renamed(c, edge, edge.a);
                stars_.add(t, c);
                if (limits_.keeps_apart) {
                    grid_.add(t, corners(c));
                }
            }
        }
        ++ages_[edge.a];
    }
    void collapse(const Candidate& edge) {
        hand_over(edge);
        apply(edge);
        quadrics_[edge.a].add(quadrics_[edge.b]);
        ++ages_[edge.b];
        for (const std::int32_t v : stars_.link({edge.a}, surface_.triangles)) {
            assess(std::min(edge.a, v), std::max(edge.a, v), [&](const Queued& one) { queue_.push(one); });
        }
    }

    /// Removes vertices and triangles that are gone.
    void finish() {
        std::vector<std::int32_t> index(surface_.points.size(), -1);
        std::size_t count = 0;
        for (std::size_t v = 0; v < surface_.points.size(); ++v) {
            if (!stars_[static_cast<std::int32_t>(v)].empty()) {
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
    mesh::SimplexStars stars_;
    std::vector<std::int32_t> ages_;
    std::vector<char> stays_;  ///< by vertex: whether a fixed triangle has it
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
