// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "base/disjoint_sets.h"
#include "boolean/input/operand_mesh.h"
#include "boolean/input/tuning.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/vertex_stars.h"

namespace mq::boolean {
namespace {

/// Joins borders of different components that run along each other: first vertices to vertices, then vertices to edges.
/// A slit within one component is a hole, and is filled without moving anything.
class CrackClosing {
  public:
    CrackClosing(OperandMesh& draft, double reach) : draft_(draft), reach_(reach) {}

    void run() {
        component_of_ = mesh::components(draft_.mates).component_of;
        find_borders();
        if (borders_.empty()) {
            return;
        }
        join_vertices();
        find_borders();
        if (!borders_.empty()) {
            put_vertices_on_edges();
        }
        std::sort(joined_.begin(), joined_.end());
        draft_.repairs.cracks = static_cast<std::size_t>(std::unique(joined_.begin(), joined_.end()) - joined_.begin());
    }

  private:
    /// A vertex and an edge of the border that passes by it.
    struct Passing {
        double distance;
        double along;  ///< parameter on the edge, 0 at its tail
        std::int32_t vertex;
        std::int32_t corner;
    };

    void find_borders() {
        draft_.find_twins();
        borders_.clear();
        shortest_.clear();
        pieces_.clear();
        edges_.clear();
        for (std::size_t h = 0; h < draft_.mates.size(); ++h) {
            if (draft_.mates[h] != mesh::kBorder) {
                continue;
            }
            const auto corner = static_cast<std::int32_t>(h);
            borders_.push_back(corner);
            edges_.push_back({draft_.tail(corner), draft_.head(corner), draft_.head(corner)});
            const double length = (draft_.vertices[draft_.head(corner)] - draft_.point(corner)).norm();
            for (const std::int32_t v : {draft_.tail(corner), draft_.head(corner)}) {
                const auto [known, fresh] = shortest_.emplace(v, length);
                known->second = fresh ? length : std::min(known->second, length);
                pieces_[v].insert(component_of_[corner / 3]);
            }
        }
    }

    std::vector<std::int32_t> border_vertices() const {
        std::vector<std::int32_t> result;
        for (const auto& entry : shortest_) {
            result.push_back(entry.first);
        }
        std::sort(result.begin(), result.end());
        return result;
    }

    /// Whether a border at a vertex is of another component than a triangle.
    bool of_another_piece(std::int32_t v, std::int32_t triangle) const {
        const std::set<std::int32_t>& own = pieces_.at(v);
        return own.size() > 1 || own.count(component_of_[triangle]) == 0;
    }

    /// How far a vertex of the border may be from what it is joined to: a crack is narrower than its edges are long.
    double reach_of(std::int32_t v) const { return std::min(reach_, InputTuning::kCrackWidth * shortest_.at(v)); }

    /// Calls visit(k) for the border edges near a vertex, by their places in borders_.
    template <typename Visit>
    void for_each_near(const mesh::AabbTree& tree, std::int32_t v, Visit&& visit) const {
        const Vec3 margin = Vec3::Constant(reach_of(v));
        tree.for_each_in_box(Box{draft_.vertices[v] - margin, draft_.vertices[v] + margin}, [&](std::int32_t k) {
            visit(k);
            return true;
        });
    }

    // ---- vertices to vertices ----

    void join_vertices() {
        const mesh::AabbTree tree(draft_.vertices, edges_);
        std::vector<std::tuple<double, std::int32_t, std::int32_t>> pairs;
        for (const std::int32_t v : border_vertices()) {
            for_each_near(tree, v, [&](std::int32_t k) {
                for (const std::int32_t w : {edges_[k][0], edges_[k][1]}) {
                    const double distance = (draft_.vertices[v] - draft_.vertices[w]).norm();
                    if (v < w && distance <= std::min(reach_of(v), reach_of(w)) &&
                        of_another_piece(v, borders_[k] / 3)) {
                        pairs.emplace_back(distance, v, w);
                    }
                }
            });
        }
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        const mesh::VertexStars stars(draft_.triangles, draft_.vertices.size());
        DisjointSets<std::int32_t> places(draft_.vertices.size());
        std::unordered_map<std::int32_t, std::vector<std::int32_t>> members;  // where several vertices share a place
        const auto members_of = [&](std::int32_t v) {
            const auto found = members.find(v);
            return found != members.end() ? found->second : std::vector<std::int32_t>{v};
        };
        for (const auto& [distance, v, w] : pairs) {
            const auto [first, second] = std::minmax({places.find(v), places.find(w)});
            const std::vector<std::int32_t> joining = members_of(second);
            if (first == second || !can_join(stars, places, first, joining)) {
                continue;
            }
            std::vector<std::int32_t> all = members_of(first);
            all.insert(all.end(), joining.begin(), joining.end());
            members.erase(second);
            members[first] = std::move(all);
            places.unite(first, second);
        }
        move_to_places(places);
    }

    /// Whether vertices may go to a place: they are near enough, and no triangle has two corners there then.
    bool can_join(const mesh::VertexStars& stars, DisjointSets<std::int32_t>& places, std::int32_t place,
                  const std::vector<std::int32_t>& joining) const {
        return std::all_of(joining.begin(), joining.end(), [&](std::int32_t v) {
            const mesh::VertexStars::Star star = stars[static_cast<std::size_t>(v)];
            return (draft_.vertices[v] - draft_.vertices[place]).norm() <= reach_ &&
                   std::none_of(star.begin(), star.end(), [&](std::uint32_t corner) {
                       const mesh::Triangle& t = draft_.triangles[corner / 3];
                       return places.find(t[0]) == place || places.find(t[1]) == place || places.find(t[2]) == place;
                   });
        });
    }

    void move_to_places(DisjointSets<std::int32_t>& places) {
        for (mesh::Triangle& t : draft_.triangles) {
            for (std::int32_t& v : t) {
                const std::int32_t place = places.find(v);
                if (place != v) {
                    note_move(v, draft_.vertices[place]);
                    v = place;
                }
            }
        }
    }

    void note_move(std::int32_t v, const Vec3& target) {
        draft_.largest_move = std::max(draft_.largest_move, (draft_.vertices[v] - target).norm());
        joined_.push_back(v);
    }

    // ---- vertices to edges ----

    /// Divides the triangles of border edges at vertices of other borders that lie along them. Each vertex is put on
    /// one edge at most, the nearest.
    void put_vertices_on_edges() {
        const mesh::AabbTree tree(draft_.vertices, edges_);
        std::vector<Passing> all;
        for (const std::int32_t v : border_vertices()) {
            Passing nearest{reach_of(v), 0.0, v, -1};
            for_each_near(tree, v, [&](std::int32_t k) { take_if_nearer(v, borders_[k], nearest); });
            if (nearest.corner >= 0) {
                all.push_back(nearest);
            }
        }
        std::sort(all.begin(), all.end(), [](const Passing& a, const Passing& b) {
            return std::tie(a.corner, a.along, a.vertex) < std::tie(b.corner, b.along, b.vertex);
        });
        for (std::size_t i = 0; i < all.size();) {
            // One edge of a triangle only: the division gives others other indices.
            std::size_t end = i;
            std::vector<std::int32_t> chain;
            for (; end < all.size() && all[end].corner / 3 == all[i].corner / 3; ++end) {
                if (all[end].corner == all[i].corner) {
                    chain.push_back(all[end].vertex);
                    draft_.largest_move = std::max(draft_.largest_move, all[end].distance);
                    joined_.push_back(all[end].vertex);
                }
            }
            divide(all[i].corner, chain);
            i = end;
        }
        draft_.find_twins();
    }

    void take_if_nearer(std::int32_t v, std::int32_t corner, Passing& nearest) const {
        const mesh::Triangle& t = draft_.triangles[corner / 3];
        if (std::find(t.begin(), t.end(), v) != t.end() || !of_another_piece(v, corner / 3)) {
            return;
        }
        const Vec3& a = draft_.point(corner);
        const Vec3 edge = draft_.vertices[draft_.head(corner)] - a;
        const double along = (draft_.vertices[v] - a).dot(edge) / edge.squaredNorm();
        const double distance = (draft_.vertices[v] - a - along * edge).norm();
        // An equally near edge counts only when it comes first.
        if (along > 0.0 && along < 1.0 &&
            (nearest.corner < 0 ? distance <= nearest.distance
                                : std::tie(distance, corner) < std::tie(nearest.distance, nearest.corner))) {
            nearest = {distance, along, v, corner};
        }
    }

    /// Divides the triangle of a border edge into a fan from the opposite corner to the pieces of the edge.
    void divide(std::int32_t corner, const std::vector<std::int32_t>& chain) {
        const std::int32_t t = corner / 3;
        const std::int32_t head = draft_.head(corner);
        const std::int32_t apex = draft_.tail(mesh::previous_corner(corner));
        draft_.triangles[t] = {draft_.tail(corner), chain.front(), apex};
        for (std::size_t i = 0; i < chain.size(); ++i) {
            draft_.triangles.push_back({chain[i], i + 1 < chain.size() ? chain[i + 1] : head, apex});
            draft_.source.push_back(draft_.source[t]);
        }
    }

    OperandMesh& draft_;
    double reach_;
    std::vector<std::int32_t> borders_;                  ///< corners on the border
    std::vector<mesh::Triangle> edges_;                  ///< their edges, as triangles for the tree
    std::unordered_map<std::int32_t, double> shortest_;  ///< by vertex of the border, its shortest border edge, mm
    std::vector<std::int32_t> component_of_;             ///< by triangle of the input
    std::unordered_map<std::int32_t, std::set<std::int32_t>> pieces_;  ///< by vertex, components with a border there
    std::vector<std::int32_t> joined_;                                 ///< vertices that were joined to something
};

}  // namespace

void close_cracks(OperandMesh& draft, double reach) {
    if (reach > 0.0) {
        CrackClosing(draft, reach).run();
    }
}

}  // namespace mq::boolean
