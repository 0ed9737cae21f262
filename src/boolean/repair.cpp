// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/repair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "base/predicates.h"
#include "boolean/flakes.h"
#include "mesh/self_intersection.h"
#include "mesh/triangle_contact.h"
#include "mesh/triangle_tree.h"
#include "mesh/vertex_stars.h"

namespace mq::boolean {

namespace {

using Faults = std::set<std::int32_t>;  // triangles

bool has(const Triangle& t, std::int32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

/// The distance of the segments p-q and r-s (Ericson, Real-Time Collision Detection, section 5.1.9).
double segment_distance(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    const Vec3 u = q - p;
    const Vec3 v = s - r;
    const Vec3 w = p - r;
    const double uu = u.dot(u);
    const double vv = v.dot(v);
    const double uv = u.dot(v);
    const double determinant = uu * vv - uv * uv;
    const auto part = [](double value, double of) { return of > 0.0 ? std::clamp(value / of, 0.0, 1.0) : 0.0; };
    double along_u = part(uv * v.dot(w) - vv * u.dot(w), determinant);
    const double along_v = part(uv * along_u + v.dot(w), vv);
    along_u = part(uv * along_v - u.dot(w), uu);
    return (w + along_u * u - along_v * v).norm();
}

/// The triangles that do not come unchanged from an operand, and those that touch their vertices.
std::vector<std::int32_t> new_triangles(const Draft& draft) {
    std::vector<std::int32_t> result;
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        if (!gone(draft.triangles[t]) && draft.source[t].operand < 0) {
            result.push_back(static_cast<std::int32_t>(t));
        }
    }
    return result;
}

class Repairer {
  public:
    Repairer(Draft& draft, double distance, const Faults& faults)
        : draft_(draft),
          distance_(distance),
          stars_(draft.triangles, draft.vertices.size()),
          changed_(draft.triangles.size(), 0) {
        Box box;
        for (const Vec3& p : draft.vertices) {
            box.add(p);
        }
        size_ = box.largest_side();
        find_regions(faults);
        rebuild();
    }

    RepairCount count;
    double largest_drift = 0.0;

    /// Works on the faults of one triangle; true when there are fewer afterwards.
    bool work_on(std::int32_t t) {
        if (gone(draft_.triangles[static_cast<std::size_t>(t)])) {
            return false;
        }
        constexpr std::size_t kMostInvolved = 5;
        std::vector<std::int32_t> involved{t};
        for (const std::int32_t other : contacts_of(t)) {
            if (involved.size() < kMostInvolved) {
                involved.push_back(other);
            }
        }
        if (changed_list_.size() > kMostChanged + static_cast<std::size_t>(4.0 * std::sqrt(changed_.size()))) {
            rebuild();
        }
        for (const double longest : {short_edge(), distance_}) {
            for (const std::int32_t i : involved) {
                if (collapse_some(i, longest) || flip_some(i) || move_some(i)) {
                    return true;
                }
            }
        }
        return false;
    }

    bool faulty(std::int32_t t) const { return !gone(triangle(t)) && (degenerate(t) || !contacts_of(t).empty()); }

  private:
    struct Undo {
        std::map<std::int32_t, Triangle> triangles;
        std::map<std::int32_t, std::vector<std::int32_t>> stars;
        std::map<std::int32_t, Vec3> vertices;
    };

    const Triangle& triangle(std::int32_t t) const { return draft_.triangles[static_cast<std::size_t>(t)]; }
    const Vec3& at(std::int32_t v) const { return draft_.vertices[static_cast<std::size_t>(v)]; }

    bool degenerate(std::int32_t t) const {
        const Triangle& c = triangle(t);
        return collinear(at(c[0]), at(c[1]), at(c[2]));
    }

    /// A few units in the last place of single precision.
    double short_edge() const {
        constexpr double kUnits = 32.0;
        return std::min(distance_, kUnits * std::numeric_limits<float>::epsilon() * size_);
    }

    Box box_of(std::int32_t t) const {
        Box box;
        for (const std::int32_t v : triangle(t)) {
            box.add(at(v));
        }
        return box;
    }

    /// The surroundings of a few faults; of many the whole surface.
    void find_regions(const Faults& faults) {
        constexpr std::size_t kFew = 32;
        if (faults.size() > kFew) {
            return;
        }
        for (const std::int32_t fault : faults) {
            Box region;
            for (const std::int32_t v : triangle(fault)) {
                for (const std::int32_t t : star(v)) {
                    const Box box = box_of(t);
                    region.add(box.low);
                    region.add(box.high);
                }
            }
            region.low -= Vec3::Constant(distance_);
            region.high += Vec3::Constant(distance_);
            regions_.push_back(region);
        }
    }
    bool near_faults(std::int32_t t) const {
        const Box box = box_of(t);
        return regions_.empty() ||
               std::any_of(regions_.begin(), regions_.end(), [&](const Box& region) { return box.meets(region); });
    }

    /// Tells the tree of all changes so far.
    void rebuild() {
        std::vector<std::int32_t> alive;
        for (std::int32_t t = 0; t < static_cast<std::int32_t>(draft_.triangles.size()); ++t) {
            if (!gone(triangle(t)) && near_faults(t)) {
                alive.push_back(t);
            }
        }
        tree_.emplace(draft_.vertices, draft_.triangles, alive);
        std::fill(changed_.begin(), changed_.end(), 0);
        changed_list_.clear();
    }

    const std::vector<std::int32_t>& star(std::int32_t v) {
        const auto known = star_.find(v);
        if (known != star_.end()) {
            return known->second;
        }
        std::vector<std::int32_t> list;
        for (const std::uint32_t corner : stars_[static_cast<std::size_t>(v)]) {
            list.push_back(static_cast<std::int32_t>(corner / 3));
        }
        return star_.emplace(v, std::move(list)).first->second;
    }

    std::vector<std::int32_t> contacts_of(std::int32_t t) const {
        std::vector<std::int32_t> result;
        const Triangle& own = triangle(t);
        const Box box = box_of(t);
        const auto test = [&](std::int32_t other) {
            if (other != t && !gone(triangle(other)) &&
                mesh::contact(draft_.vertices, own, triangle(other)) != mesh::Contact::None) {
                result.push_back(other);
            }
        };
        tree_->for_each_in_box(box, [&](std::int32_t other) {
            if (changed_[static_cast<std::size_t>(other)] == 0) {
                test(other);
            }
        });
        for (const std::int32_t other : changed_list_) {
            if (!gone(triangle(other)) && box.meets(box_of(other))) {
                test(other);
            }
        }
        std::sort(result.begin(), result.end());
        return result;
    }

    std::size_t faults_of(const std::vector<std::int32_t>& triangles) const {
        std::set<std::array<std::int32_t, 2>> pairs;
        std::size_t result = 0;
        for (const std::int32_t t : triangles) {
            if (!gone(triangle(t))) {
                result += degenerate(t) ? 1 : 0;
                for (const std::int32_t other : contacts_of(t)) {
                    pairs.insert({std::min(t, other), std::max(t, other)});
                }
            }
        }
        return result + pairs.size();
    }

    void note(Undo& undo, std::int32_t t) {
        undo.triangles.emplace(t, triangle(t));
        for (const std::int32_t v : triangle(t)) {
            undo.stars.emplace(v, star(v));
        }
    }
    void mark(std::int32_t t) {
        if (changed_[static_cast<std::size_t>(t)] == 0) {
            changed_[static_cast<std::size_t>(t)] = 1;
            changed_list_.push_back(t);
        }
    }
    void undo(const Undo& before) {
        for (const auto& [t, corners] : before.triangles) {
            draft_.triangles[static_cast<std::size_t>(t)] = corners;
        }
        for (const auto& [v, list] : before.stars) {
            star_[v] = list;
        }
        for (const auto& [v, point] : before.vertices) {
            draft_.vertices[static_cast<std::size_t>(v)] = point;
        }
    }

    /// Makes a change of some triangles, and takes it back unless fewer faults are left.
    template <typename Change>
    bool attempt(const std::vector<std::int32_t>& affected, Change&& change) {
        const std::size_t before = faults_of(affected);
        Undo taken;
        for (const std::int32_t t : affected) {
            note(taken, t);
        }
        for (const std::int32_t t : affected) {
            mark(t);
        }
        if (before > 0 && change(taken) && faults_of(affected) < before) {
            for (const std::int32_t t : affected) {
                draft_.source[static_cast<std::size_t>(t)] = Source{};
            }
            return true;
        }
        undo(taken);
        return false;
    }

    void replace(std::int32_t t, const Triangle& corners) {
        for (const std::int32_t v : triangle(t)) {
            auto& list = star_[v];
            list.erase(std::remove(list.begin(), list.end(), t), list.end());
        }
        draft_.triangles[static_cast<std::size_t>(t)] = corners;
        if (!gone(corners)) {
            for (const std::int32_t v : corners) {
                star(v);
                star_[v].push_back(t);
            }
        }
    }

    bool collapse_some(std::int32_t t, double longest) {
        const Triangle c = triangle(t);
        std::vector<std::pair<double, std::array<std::int32_t, 2>>> order;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t a = c[k];
            const std::int32_t b = c[(k + 1) % 3];
            const double length = (at(a) - at(b)).norm();
            if (length <= longest) {
                order.push_back({length, {a, b}});
                order.push_back({length, {b, a}});
            }
        }
        std::sort(order.begin(), order.end());
        return std::any_of(order.begin(), order.end(), [&](const auto& entry) {
            const auto [from, to] = entry.second;
            return draft_.made[static_cast<std::size_t>(from)] != kOwn && collapse(from, to);
        });
    }

    bool collapse(std::int32_t from, std::int32_t to) {
        if (!link_condition(from, to)) {
            return false;
        }
        const std::vector<std::int32_t> affected = star(from);
        const double step = (at(from) - at(to)).norm();
        const bool done = attempt(affected, [&](Undo&) {
            for (const std::int32_t t : affected) {
                Triangle corners = triangle(t);
                if (has(corners, to)) {
                    replace(t, kGone);
                } else {
                    std::replace(corners.begin(), corners.end(), from, to);
                    replace(t, corners);
                }
            }
            return true;
        });
        if (done) {
            ++count.collapsed;
            drift(to, std::max(drift_[to], drift_[from] + step));
        }
        return done;
    }

    /// The ends of the edge have just the two apexes of its triangles as common neighbours, and each of the three
    /// vertices that stay keeps at least three triangles.
    bool link_condition(std::int32_t a, std::int32_t b) {
        const auto neighbours = [&](std::int32_t v) {
            std::set<std::int32_t> result;
            for (const std::int32_t t : star(v)) {
                result.insert(triangle(t).begin(), triangle(t).end());
            }
            return result;
        };
        const std::set<std::int32_t> of_a = neighbours(a);
        const std::set<std::int32_t> of_b = neighbours(b);
        std::size_t common = 0;
        bool enough = star(a).size() + star(b).size() >= 7;
        for (const std::int32_t v : of_a) {
            if (v != a && v != b && of_b.count(v) > 0) {
                ++common;
                enough = enough && star(v).size() >= 4;
            }
        }
        return common == 2 && enough;
    }

    bool flip_some(std::int32_t t) {
        const Triangle c = triangle(t);
        std::array<std::size_t, 3> order{0, 1, 2};
        std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
            return (at(c[i]) - at(c[(i + 1) % 3])).norm() > (at(c[j]) - at(c[(j + 1) % 3])).norm();
        });
        return std::any_of(order.begin(), order.end(),
                           [&](std::size_t k) { return flip(t, c[k], c[(k + 1) % 3], c[(k + 2) % 3]); });
    }

    /// Swaps the edge from a to b of triangle t with the apex c, when that moves the surface by no more than allowed.
    bool flip(std::int32_t t, std::int32_t a, std::int32_t b, std::int32_t c) {
        std::int32_t other = -1;
        std::int32_t d = -1;
        for (const std::int32_t s : star(a)) {
            if (s != t && has(triangle(s), b)) {
                other = s;
                for (const std::int32_t v : triangle(s)) {
                    d = v != a && v != b ? v : d;
                }
            }
        }
        if (other < 0 || d == c || joined(c, d) || segment_distance(at(a), at(b), at(c), at(d)) > distance_) {
            return false;
        }
        const bool done = attempt({t, other}, [&](Undo& taken) {
            taken.stars.emplace(c, star(c));
            taken.stars.emplace(d, star(d));
            replace(t, {d, b, c});
            replace(other, {c, a, d});
            return true;
        });
        if (done) {
            // Seen from where the two edges come nearest, either pair of triangles is four, each near one of the other.
            const double step = segment_distance(at(a), at(b), at(c), at(d));
            const double sum = step + std::max({drift_[a], drift_[b], drift_[c], drift_[d]});
            for (const std::int32_t v : {a, b, c, d}) {
                drift(v, sum);
            }
            ++count.flipped;
        }
        return done;
    }

    bool joined(std::int32_t a, std::int32_t b) {
        const auto& list = star(a);
        return std::any_of(list.begin(), list.end(), [&](std::int32_t t) { return has(triangle(t), b); });
    }

    /// The surface at a vertex has moved so far in all, mm.
    void drift(std::int32_t v, double length) {
        drift_[v] = length;
        largest_drift = std::max(largest_drift, length);
    }

    bool move_some(std::int32_t t) {
        const Triangle c = triangle(t);
        return std::any_of(c.begin(), c.end(),
                           [&](std::int32_t v) { return draft_.made[static_cast<std::size_t>(v)] != kOwn && move(v); });
    }

    /// Tries the other places of a parted vertex, then those near it, one and then several units of single precision
    /// away.
    bool move(std::int32_t v) {
        constexpr double kUnits[] = {1.0, 6.0};
        const Vec3 before = at(v);
        const auto places = draft_.places.find(v);
        if (places != draft_.places.end() && std::any_of(places->second.begin(), places->second.end(),
                                                         [&](const Vec3& p) { return p != before && move_to(v, p); })) {
            return true;
        }
        for (const double units : kUnits) {
            const double step = units * std::numeric_limits<float>::epsilon() * size_;
            for (int code = 0; code < 27; ++code) {
                const Vec3 way(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
                const Vec3 p = to_single(before + step * way);
                if (p != before && (p - before).norm() <= distance_ && move_to(v, p)) {
                    return true;
                }
            }
        }
        return false;
    }

    bool move_to(std::int32_t v, const Vec3& p) {
        const Vec3 before = at(v);
        const bool done = attempt(star(v), [&](Undo& taken) {
            taken.vertices.emplace(v, before);
            draft_.vertices[static_cast<std::size_t>(v)] = p;
            return true;
        });
        if (done) {
            ++count.moved;
            drift(v, drift_[v] + (p - before).norm());
        }
        return done;
    }

    static constexpr std::size_t kMostChanged = 256;

    Draft& draft_;
    double distance_;
    mesh::VertexStars stars_;
    std::optional<mesh::TriangleTree> tree_;
    std::vector<Box> regions_;  ///< that the tree knows; none: all
    double size_ = 0.0;
    std::map<std::int32_t, std::vector<std::int32_t>> star_;  ///< of vertices looked at, as it is now
    std::map<std::int32_t, double> drift_;                    ///< of vertices
    std::vector<char> changed_;                               ///< triangles that the tree no longer knows
    std::vector<std::int32_t> changed_list_;
};

/// Of some triangles and what they meet.
Faults find_faults(const Draft& draft, const std::vector<std::int32_t>& fresh, const Progress& progress) {
    Faults faults;
    for (const mesh::ContactPair& pair :
         mesh::self_intersections_with(draft.vertices, draft.triangles, fresh, mesh::kAllPairs, &progress)) {
        faults.insert(pair.a);
        faults.insert(pair.b);
    }
    for (const std::int32_t t : fresh) {
        const Triangle& c = draft.triangles[static_cast<std::size_t>(t)];
        if (collinear(draft.vertices[static_cast<std::size_t>(c[0])], draft.vertices[static_cast<std::size_t>(c[1])],
                      draft.vertices[static_cast<std::size_t>(c[2])])) {
            faults.insert(t);
        }
    }
    return faults;
}

}  // namespace

void round_to_single(Draft& draft) {
    for (std::size_t v = 0; v < draft.vertices.size(); ++v) {
        if (draft.made[v] != kOwn) {
            const Vec3 exact = draft.vertices[v];
            draft.vertices[v] = to_single(exact);
            draft.largest_move = std::max(draft.largest_move, (draft.vertices[v] - exact).norm());
        }
    }
}

std::size_t count_parting_faults(const Draft& draft, const Progress& progress) {
    std::vector<std::int32_t> parted;
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        const Triangle& c = draft.triangles[t];
        if (std::any_of(c.begin(), c.end(),
                        [&](std::int32_t v) { return draft.made[static_cast<std::size_t>(v)] == kParted; })) {
            parted.push_back(static_cast<std::int32_t>(t));
        }
    }
    return find_faults(draft, parted, progress).size();
}

RepairCount repair(Draft& draft, double distance, const Progress& progress) {
    constexpr int kRounds = 4;
    constexpr double kThinnest = 0.02;  // of the distance allowed, some units of single precision
    RepairCount total;
    Faults faults = find_faults(draft, new_triangles(draft), progress);
    bool changed = true;
    for (int round = 0; round < kRounds && changed && !faults.empty(); ++round) {
        const std::size_t before = total.collapsed + total.flipped + total.moved;
        {
            Repairer repairer(draft, distance, faults);
            for (const std::int32_t t : faults) {
                progress.check();
                while (repairer.faulty(t) && repairer.work_on(t)) {
                }
            }
            total.collapsed += repairer.count.collapsed;
            total.flipped += repairer.count.flipped;
            total.moved += repairer.count.moved;
            draft.largest_move += repairer.largest_drift;
        }
        changed = total.collapsed + total.flipped + total.moved > before;
        remove_gone(draft);
        if (changed) {
            faults = find_faults(draft, new_triangles(draft), progress);
        }
    }
    if (!faults.empty()) {
        total.flakes = remove_flakes(draft, faults, kThinnest * distance);
        remove_gone(draft);
        if (total.flakes > 0) {
            faults = find_faults(draft, new_triangles(draft), progress);
        }
    }
    if (total.collapsed > 0 || total.flakes > 0) {
        remove_unused_vertices(draft);
    }
    total.faulty.assign(faults.begin(), faults.end());
    return total;
}

}  // namespace mq::boolean
