// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/vertex_relocation.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "base/disjoint_sets.h"
#include "base/predicates.h"
#include "boolean/rounding/tuning.h"
#include "boolean/rounding/vertex_merging.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/intersection/needle_frame.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/vertex_stars.h"

namespace mq::boolean {

namespace {

using TrianglePair = std::array<std::int32_t, 2>;
using Group = std::vector<std::int32_t>;  ///< vertices that move together

bool same_corners(Triangle a, Triangle b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
}

/// The triangles around a group of vertices, and the pairs of one of these and another triangle that may meet while the
/// group moves, each once. Pairs that met last come first, so that bad places are soon found to be bad.
struct Surroundings {
    std::vector<std::int32_t> star;
    std::vector<TrianglePair> pairs;
};

class VertexRelocation {
  public:
    VertexRelocation(ResultMesh& draft, const RelocationOptions& options, const Progress& progress)
        : draft_(draft), options_(options), progress_(progress) {
        find_faults();
    }

    bool embedded() const { return pairs_ + flat_.size() == 0; }

    /// Rounds the constructed vertices at faults, so that those nearer to each other than the grid can be merged.
    void round_at_faults() {
        std::set<std::int32_t> faulty = flat_;
        for (const auto& entry : partners_) {
            faulty.insert(entry.first);
        }
        std::vector<double> distances(draft_.vertices.size(), 0.0);
        for (const std::int32_t t : faulty) {
            for (const std::int32_t v : triangle(t)) {
                const Vec3 place = constructed(v) ? options_.rounded(at(v)) : at(v);
                if (place != at(v)) {
                    distances[static_cast<std::size_t>(v)] = (place - at(v)).norm();
                    draft_.vertices[static_cast<std::size_t>(v)] = place;
                    rounded_ = true;
                }
            }
        }
        add_displacements(draft_, distances);
    }
    bool rounded() const { return rounded_; }

    EmbeddingFaults run() {
        if (!embedded() && !is_tangle_) {
            frame_.emplace(draft_.vertices, draft_.triangles);
            tree_.emplace(frame_->vertices(), draft_.triangles, frame_->slack() + options_.reach);
            stars_.emplace(draft_.triangles, draft_.vertices.size());
            while (sweep() > 0) {
            }
            record_moves();
        }
        EmbeddingFaults result{contacts(), {flat_.begin(), flat_.end()}, false, is_tangle_};
        result.may_have_turned = moves_ > 0 && has_thin_piece();
        return result;
    }

  private:
    const Vec3& at(std::int32_t v) const { return draft_.vertices[static_cast<std::size_t>(v)]; }
    const Triangle& triangle(std::int32_t t) const { return draft_.triangles[static_cast<std::size_t>(t)]; }
    bool constructed(std::int32_t v) const { return draft_.made[static_cast<std::size_t>(v)] == kConstructed; }
    bool has_no_area(std::int32_t t) const {
        const Triangle& c = triangle(t);
        return collinear(at(c[0]), at(c[1]), at(c[2]));
    }

    std::vector<TrianglePair> contacts() const {
        std::vector<TrianglePair> result;
        for (const auto& [t, others] : partners_) {
            for (auto other = others.upper_bound(t); other != others.end(); ++other) {
                result.push_back({t, *other});
            }
        }
        return result;
    }

    void find_faults() {
        std::vector<std::int32_t> changed;
        for (std::int32_t t = 0; t < static_cast<std::int32_t>(draft_.triangles.size()); ++t) {
            const Triangle& c = triangle(t);
            if (constructed(c[0]) || constructed(c[1]) || constructed(c[2])) {
                changed.push_back(t);
                if (has_no_area(t)) {
                    flat_.insert(t);
                }
            }
        }
        // Thousands of sheets through each other have millions of pairs, which take minutes to find.
        const std::size_t most = std::max(RoundingTuning::kTangle, draft_.triangles.size());
        const std::vector<mesh::ContactPair> pairs =
            mesh::self_intersections_with(draft_.vertices, draft_.triangles, changed, most + 1, &progress_);
        for (const mesh::ContactPair& pair : pairs) {
            if (!same_corners(triangle(pair.a), triangle(pair.b))) {
                connect(pair.a, pair.b);
            }
        }
        is_tangle_ = std::max(pairs.size(), pairs_ + flat_.size()) > most;
    }

    void connect(std::int32_t a, std::int32_t b) {
        if (partners_[a].insert(b).second) {
            partners_[b].insert(a);
            ++pairs_;
        }
    }
    bool in_contact(std::int32_t a, std::int32_t b) const {
        const auto found = partners_.find(a);
        return found != partners_.end() && found->second.count(b) > 0;
    }
    void disconnect(std::int32_t t) {
        const auto found = partners_.find(t);
        if (found == partners_.end()) {
            return;
        }
        pairs_ -= found->second.size();
        for (const std::int32_t other : found->second) {
            const auto there = partners_.find(other);
            there->second.erase(t);
            if (there->second.empty()) {
                partners_.erase(there);
            }
        }
        partners_.erase(found);
    }

    void record_moves() {
        std::vector<double> distances(draft_.vertices.size(), 0.0);
        for (const auto& [v, start] : start_) {
            distances[static_cast<std::size_t>(v)] = (at(v) - start).norm();
        }
        add_displacements(draft_, distances);
    }

    /// Whether there is a component whose volume is at most its area times twice the reach: only such a one can turn
    /// inside out, or be passed by a vertex as a whole, while nothing is in contact before and after.
    bool has_thin_piece() const {
        struct Extent {
            double volume = 0.0;
            double area = 0.0;
        };
        DisjointSets<std::int32_t> components(draft_.vertices.size());
        for (const Triangle& c : draft_.triangles) {
            components.unite(c[0], c[1]);
            components.unite(c[1], c[2]);
        }
        std::unordered_map<std::int32_t, Extent> extents;
        for (const Triangle& c : draft_.triangles) {
            const std::int32_t component = components.find(c[0]);
            Extent& extent = extents[component];
            const Vec3 area = (at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0]));
            extent.volume += area.dot(at(c[0]) - at(component)) / 6.0;
            extent.area += 0.5 * area.norm();
        }
        return std::any_of(extents.begin(), extents.end(), [&](const auto& entry) {
            return std::abs(entry.second.volume) <= 2.0 * options_.reach * entry.second.area;
        });
    }

    /// Tries to move vertices at each fault. Returns the number of moves.
    std::size_t sweep() {
        std::size_t moves = 0;
        const std::set<std::int32_t> flat = flat_;
        for (const std::int32_t t : flat) {
            while (flat_.count(t) > 0 && move_off(t, -1)) {
                ++moves;
            }
        }
        for (const auto& [a, b] : contacts()) {
            if (in_contact(a, b) && move_off(a, b)) {
                ++moves;
            }
        }
        return moves;
    }

    /// The groups to try: single constructed vertices, those of each triangle together, and then the other vertices
    /// likewise.
    std::vector<Group> groups_of(std::int32_t a, std::int32_t b) const {
        std::vector<Group> groups;
        const auto add = [&](const Group& group) {
            if (!group.empty() && std::find(groups.begin(), groups.end(), group) == groups.end()) {
                groups.push_back(group);
            }
        };
        for (const bool all : {false, true}) {
            for (const bool together : {false, true}) {
                for (const std::int32_t t : {a, b}) {
                    Group group;
                    for (std::size_t k = 0; k < 3 && t >= 0; ++k) {
                        const std::int32_t v = triangle(t)[k];
                        if (all || constructed(v)) {
                            group.push_back(v);
                            add(together ? Group() : Group{v});
                        }
                    }
                    add(together ? group : Group());
                }
            }
        }
        return groups;
    }

    /// Moves vertices of two triangles in contact, or of one without area (b is -1).
    bool move_off(std::int32_t a, std::int32_t b) {
        const std::vector<Group> groups = groups_of(a, b);
        std::vector<Vec3> ways;
        for (const std::int32_t t : {b, a}) {
            if (t >= 0) {
                const Triangle& c = triangle(t);
                const Vec3 n = (at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0])).normalized();
                if (n.allFinite() && !n.isZero()) {
                    ways.push_back(n);
                    ways.push_back(-n);
                }
            }
        }
        for (int k = 0; k < 27; ++k) {
            const Vec3 way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
            if (!way.isZero()) {
                ways.push_back(way.normalized());
            }
        }
        return std::any_of(groups.begin(), groups.end(), [&](const Group& group) { return move(group, ways); });
    }

    /// Moves a group to the position with the fewest faults, if these are fewer than now.
    bool move(const Group& group, const std::vector<Vec3>& ways) {
        if (stuck(group)) {
            return false;
        }
        progress_.check();
        Surroundings around = surroundings(group);
        std::vector<Vec3> before;
        for (const std::int32_t v : group) {
            before.push_back(at(v));
            start_.emplace(v, at(v));
        }
        std::size_t fewest = count(around, mesh::kAllPairs);
        std::vector<Vec3> best;
        for (double length = options_.unit; length <= options_.reach && best.empty(); length *= 4.0) {
            for (const Vec3& way : ways) {
                if (!place(group, before, length * way)) {
                    continue;
                }
                const std::size_t faults = count(around, fewest);
                if (faults < fewest) {
                    fewest = faults;
                    best.clear();
                    for (const std::int32_t v : group) {
                        best.push_back(at(v));
                    }
                    if (fewest == 0) {
                        break;
                    }
                }
            }
        }
        const std::vector<Vec3>& final = best.empty() ? before : best;
        for (std::size_t i = 0; i < group.size(); ++i) {
            draft_.vertices[static_cast<std::size_t>(group[i])] = final[i];
        }
        if (best.empty()) {
            stuck_[group] = moves_;
            return false;
        }
        for (const std::int32_t v : group) {
            draft_.made[static_cast<std::size_t>(v)] = kConstructed;
        }
        for (const std::int32_t t : around.star) {
            draft_.source[static_cast<std::size_t>(t)] = Source{};
        }
        update(around);
        return true;
    }

    /// Whether the group was tried in vain, and no triangle at its vertices, nor one in contact with those, has moved
    /// since then.
    bool stuck(const Group& group) const {
        const auto found = stuck_.find(group);
        return found != stuck_.end() && std::all_of(group.begin(), group.end(), [&](std::int32_t v) {
                   const auto changed = changed_.find(v);
                   return changed == changed_.end() || changed->second <= found->second;
               });
    }

    /// Moves the vertices of a group from `from` by `displacement` and rounds them. False if one would leave its reach
    /// or none moves.
    bool place(const Group& group, const std::vector<Vec3>& from, const Vec3& displacement) {
        bool moves = false;
        for (std::size_t i = 0; i < group.size(); ++i) {
            const Vec3 target = options_.rounded(from[i] + displacement);
            if ((target - start_.at(group[i])).norm() > options_.reach) {
                return false;
            }
            moves = moves || target != from[i];
            draft_.vertices[static_cast<std::size_t>(group[i])] = target;
        }
        return moves;
    }

    Surroundings surroundings(const Group& group) const {
        Surroundings result;
        for (const std::int32_t v : group) {
            for (const std::uint32_t corner : (*stars_)[static_cast<std::size_t>(v)]) {
                result.star.push_back(static_cast<std::int32_t>(corner / 3));
            }
        }
        std::sort(result.star.begin(), result.star.end());
        result.star.erase(std::unique(result.star.begin(), result.star.end()), result.star.end());
        for (const std::int32_t t : result.star) {
            Box box;
            for (const std::int32_t v : triangle(t)) {
                box.add(frame_->turned(at(v)));
            }
            // The present place of a vertex and all later ones are within the reach of its first place.
            box.low -= Vec3::Constant(2.0 * options_.reach + frame_->slack());
            box.high += Vec3::Constant(2.0 * options_.reach + frame_->slack());
            tree_->for_each_in_box(box, [&](std::int32_t other) {
                const bool listed = other < t && std::binary_search(result.star.begin(), result.star.end(), other);
                if (other != t && !listed && !same_corners(triangle(other), triangle(t))) {
                    result.pairs.push_back({t, other});
                }
            });
        }
        std::stable_partition(result.pairs.begin(), result.pairs.end(),
                              [&](const TrianglePair& pair) { return in_contact(pair[0], pair[1]); });
        return result;
    }

    bool meet(const TrianglePair& pair) const {
        const auto box = [&](std::int32_t t) {
            const Triangle& c = triangle(t);
            return Box{at(c[0]).cwiseMin(at(c[1])).cwiseMin(at(c[2])), at(c[0]).cwiseMax(at(c[1])).cwiseMax(at(c[2]))};
        };
        const Box a = box(pair[0]);
        const Box b = box(pair[1]);
        return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all() &&
               mesh::contact(draft_.vertices, triangle(pair[0]), triangle(pair[1])) != mesh::Contact::None;
    }

    /// The faults of the star, at most `limit`.
    std::size_t count(Surroundings& around, std::size_t limit) const {
        const auto flat = static_cast<std::size_t>(
            std::count_if(around.star.begin(), around.star.end(), [&](std::int32_t t) { return has_no_area(t); }));
        std::size_t met = 0;
        for (std::size_t i = 0; i < around.pairs.size() && flat + met < limit; ++i) {
            if (meet(around.pairs[i])) {
                std::swap(around.pairs[i], around.pairs[met]);
                ++met;
            }
        }
        return flat + met;
    }

    void update(const Surroundings& around) {
        ++moves_;
        const auto mark = [&](std::int32_t t) {
            for (const std::int32_t v : triangle(t)) {
                changed_[v] = moves_;
            }
        };
        for (const std::int32_t t : around.star) {
            mark(t);
            const auto found = partners_.find(t);
            if (found != partners_.end()) {
                std::for_each(found->second.begin(), found->second.end(), mark);
            }
        }
        for (const std::int32_t t : around.star) {
            disconnect(t);
            flat_.erase(t);
            if (has_no_area(t)) {
                flat_.insert(t);
            }
        }
        for (const TrianglePair& pair : around.pairs) {
            if (meet(pair)) {
                connect(pair[0], pair[1]);
            }
        }
    }

    ResultMesh& draft_;
    const RelocationOptions& options_;
    const Progress& progress_;
    std::map<std::int32_t, std::set<std::int32_t>> partners_;  ///< by triangle: the triangles in contact with it
    std::size_t pairs_ = 0;
    std::set<std::int32_t> flat_;  ///< triangles without area
    bool rounded_ = false;         ///< whether a vertex at a fault was rounded
    bool is_tangle_ = false;       ///< not all pairs are known
    std::size_t moves_ = 0;
    std::map<Group, std::size_t> stuck_;                     ///< groups tried in vain, and the moves made before
    std::unordered_map<std::int32_t, std::size_t> changed_;  ///< by vertex, the last move at which it was marked
    std::unordered_map<std::int32_t, Vec3> start_;           ///< first place of each vertex that was tried
    std::optional<mesh::NeedleFrame> frame_;
    std::optional<mesh::AabbTree> tree_;  ///< over the places at the start, with boxes enlarged by the reach
    std::optional<mesh::VertexStars> stars_;
};

}  // namespace

EmbeddingFaults relocate_vertices(ResultMesh& draft, const RelocationOptions& options, const Progress& progress) {
    VertexRelocation relocation(draft, options, progress);
    if (relocation.embedded()) {
        return {};
    }
    relocation.round_at_faults();
    const bool merged = merge_coincident_vertices(draft);
    return merged || relocation.rounded() ? VertexRelocation(draft, options, progress).run() : relocation.run();
}

}  // namespace mq::boolean
