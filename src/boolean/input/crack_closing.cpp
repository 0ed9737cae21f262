// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "base/disjoint_sets.h"
#include "boolean/input/operand_mesh.h"
#include "boolean/input/tuning.h"
#include "mesh/edge_table.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/vertex_stars.h"

namespace mq::boolean {
namespace {

/// Joins borders of different components that run along each other: first vertices to vertices, then vertices to edges.
/// A slit within one component is a hole, and is filled without moving anything.
class CrackClosing {
  public:
    CrackClosing(OperandMesh& draft, double reach, const Progress* progress)
        : draft_(draft), reach_(reach), progress_(progress) {}

    void run() {
        find_borders();
        if (borders_.empty()) {
            return;
        }
        find_components();
        draft_.largest_move = join_vertices();
        draft_.find_twins();
        find_borders();
        if (!borders_.empty()) {
            draft_.largest_move += put_vertices_on_edges();
        }
        std::sort(joined_.begin(), joined_.end());
        draft_.repairs.cracks = static_cast<std::size_t>(std::unique(joined_.begin(), joined_.end()) - joined_.begin());
    }

  private:
    /// A vertex of the border, and an edge of another border on which it may be put.
    struct VertexOnEdge {
        double distance;
        double along;  ///< parameter on the edge, 0 at its tail
        std::int32_t vertex;
        std::int32_t corner;
    };

    /// A vertex of the border, and the corners of the border edges at it.
    struct BorderVertex {
        double shortest = std::numeric_limits<double>::infinity();  ///< length of its shortest border edge, mm
        std::vector<std::int32_t> corners;
    };

    /// Components are joined across edges, whatever number of triangles these have, and whichever way they run.
    void find_components() {
        DisjointSets<std::int32_t> sets(draft_.triangles.size());
        mesh::EdgeTable(draft_.triangles, draft_.vertices.size())
            .for_each([&](std::int32_t, std::int32_t, const std::uint32_t* first, const std::uint32_t* last) {
                for (const std::uint32_t* corner = first + 1; corner != last; ++corner) {
                    sets.unite(static_cast<std::int32_t>(*first / 3), static_cast<std::int32_t>(*corner / 3));
                }
            });
        std::int32_t count = 0;
        component_of_ = sets.number(count);
    }

    void find_borders() {
        borders_.clear();
        vertices_.clear();
        edges_.clear();
        for (std::size_t h = 0; h < draft_.mates.size(); ++h) {
            if (draft_.mates[h] != mesh::kBorder) {
                continue;
            }
            const auto corner = static_cast<std::int32_t>(h);
            borders_.push_back(corner);
            edges_.push_back({draft_.tail(corner), draft_.head(corner), draft_.head(corner)});
            const double length = edge(corner).norm();
            for (const std::int32_t v : {draft_.tail(corner), draft_.head(corner)}) {
                BorderVertex& vertex = vertices_[v];
                vertex.shortest = std::min(vertex.shortest, length);
                vertex.corners.push_back(corner);
            }
        }
    }

    std::vector<std::int32_t> border_vertices() const {
        std::vector<std::int32_t> result;
        for (const auto& entry : vertices_) {
            result.push_back(entry.first);
        }
        std::sort(result.begin(), result.end());
        return result;
    }

    Vec3 edge(std::int32_t corner) const { return draft_.vertices[draft_.head(corner)] - draft_.point(corner); }

    /// Whether the triangles of two border edges of different components face each other across a crack: the edges run
    /// along each other, in opposite directions or else with triangles that do not lie on one another. A solid nested
    /// in another one, both open at one place, makes no crack.
    bool face_each_other(std::int32_t h, std::int32_t g) const {
        if (component_of_[h / 3] == component_of_[g / 3]) {
            return false;
        }
        const Vec3 one = edge(h).normalized();
        const Vec3 two = edge(g).normalized();
        const auto inward = [&](std::int32_t corner, const Vec3& along) {
            const Vec3 arm = draft_.point(mesh::previous_corner(corner)) - draft_.point(corner);
            return Vec3((arm - arm.dot(along) * along).normalized());
        };
        const double along = one.dot(two);
        return along < -InputTuning::kCrackCosine ||
               (along > InputTuning::kCrackCosine && inward(h, one).dot(inward(g, two)) < InputTuning::kCrackCosine);
    }

    /// Whether a border at a vertex and a border edge face each other.
    bool faces(std::int32_t v, std::int32_t corner) const {
        const std::vector<std::int32_t>& own = vertices_.at(v).corners;
        return std::any_of(own.begin(), own.end(), [&](std::int32_t h) { return face_each_other(h, corner); });
    }

    /// The largest distance of a border vertex from the vertex or edge that it is joined with: a crack is narrower than
    /// its edges are long.
    double reach_of(std::int32_t v) const {
        return std::min(reach_, InputTuning::kCrackWidth * vertices_.at(v).shortest);
    }

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

    /// @return the largest move, mm
    double join_vertices() {
        const mesh::AabbTree tree(draft_.vertices, edges_);
        std::vector<std::tuple<double, std::int32_t, std::int32_t>> pairs;
        for (const std::int32_t v : border_vertices()) {
            check_cancelled(progress_);
            for_each_near(tree, v, [&](std::int32_t k) {
                for (const std::int32_t w : {edges_[k][0], edges_[k][1]}) {
                    const double distance = (draft_.vertices[v] - draft_.vertices[w]).norm();
                    if (v < w && distance <= std::min(reach_of(v), reach_of(w)) && faces(v, borders_[k])) {
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
        const auto members_of = [&](std::int32_t v) -> std::vector<std::int32_t>& {
            return members.emplace(v, std::vector<std::int32_t>{v}).first->second;
        };
        for (const auto& [distance, v, w] : pairs) {
            const auto [first, second] = std::minmax({places.find(v), places.find(w)});
            if (first == second || !can_join(stars, places, first, members_of(second))) {
                continue;
            }
            check_cancelled(progress_);
            std::vector<std::int32_t>& all = members_of(first);
            const std::vector<std::int32_t>& joining = members.at(second);
            all.insert(all.end(), joining.begin(), joining.end());
            members.erase(second);
            places.unite(first, second);
        }
        return move_to_places(places);
    }

    /// Whether vertices may be moved to a place: it is near enough, and no triangle would have two corners in it.
    bool can_join(const mesh::VertexStars& stars, DisjointSets<std::int32_t>& places, std::int32_t place,
                  const std::vector<std::int32_t>& joining) const {
        return std::all_of(joining.begin(), joining.end(), [&](std::int32_t v) {
            const mesh::VertexStars::Star star = stars[static_cast<std::size_t>(v)];
            return (draft_.vertices[v] - draft_.vertices[place]).norm() <= std::min(reach_of(v), reach_of(place)) &&
                   std::none_of(star.begin(), star.end(), [&](std::uint32_t corner) {
                       const mesh::Triangle& t = draft_.triangles[corner / 3];
                       return places.find(t[0]) == place || places.find(t[1]) == place || places.find(t[2]) == place;
                   });
        });
    }

    double move_to_places(DisjointSets<std::int32_t>& places) {
        double largest = 0.0;
        for (mesh::Triangle& t : draft_.triangles) {
            for (std::int32_t& v : t) {
                const std::int32_t place = places.find(v);
                if (place != v) {
                    largest = std::max(largest, (draft_.vertices[v] - draft_.vertices[place]).norm());
                    joined_.push_back(v);
                    v = place;
                }
            }
        }
        return largest;
    }

    // ---- vertices to edges ----

    /// Divides the triangles of border edges at vertices of other borders that lie along them. Each vertex is put on
    /// one edge at most, the nearest.
    /// @return the largest distance of a vertex from its edge, mm
    double put_vertices_on_edges() {
        double largest = 0.0;
        const mesh::AabbTree tree(draft_.vertices, edges_);
        std::vector<VertexOnEdge> all;
        for (const std::int32_t v : border_vertices()) {
            check_cancelled(progress_);
            VertexOnEdge nearest{reach_of(v), 0.0, v, -1};
            for_each_near(tree, v, [&](std::int32_t k) { keep_if_nearer(v, borders_[k], nearest); });
            if (nearest.corner >= 0) {
                all.push_back(nearest);
            }
        }
        std::sort(all.begin(), all.end(), [](const VertexOnEdge& a, const VertexOnEdge& b) {
            return std::tie(a.corner, a.along, a.vertex) < std::tie(b.corner, b.along, b.vertex);
        });
        for (std::size_t i = 0; i < all.size();) {
            // Divides at one edge of a triangle only, as the division gives the others new indices.
            std::size_t end = i;
            std::vector<std::int32_t> chain;
            for (; end < all.size() && all[end].corner / 3 == all[i].corner / 3; ++end) {
                if (all[end].corner == all[i].corner) {
                    chain.push_back(all[end].vertex);
                    largest = std::max(largest, all[end].distance);
                    joined_.push_back(all[end].vertex);
                }
            }
            divide(all[i].corner, chain);
            i = end;
        }
        draft_.find_twins();
        return largest;
    }

    void keep_if_nearer(std::int32_t v, std::int32_t corner, VertexOnEdge& nearest) const {
        const mesh::Triangle& t = draft_.triangles[corner / 3];
        if (std::find(t.begin(), t.end(), v) != t.end() || !faces(v, corner)) {
            return;
        }
        const Vec3& a = draft_.point(corner);
        const Vec3 whole = edge(corner);
        const double along = (draft_.vertices[v] - a).dot(whole) / whole.squaredNorm();
        const double distance = (draft_.vertices[v] - a - along * whole).norm();
        // An equally near edge counts only when it comes first.
        if (along > 0.0 && along < 1.0 && distance <= InputTuning::kCrackWidth * whole.norm() &&
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
    const Progress* progress_;
    std::vector<std::int32_t> component_of_;                   ///< by triangle of the input
    std::vector<std::int32_t> borders_;                        ///< corners on the border
    std::vector<mesh::Triangle> edges_;                        ///< border edges, as triangles for the tree
    std::unordered_map<std::int32_t, BorderVertex> vertices_;  ///< vertices on the border
    std::vector<std::int32_t> joined_;                         ///< vertices that were joined to something
};

}  // namespace

void close_cracks(OperandMesh& draft, double reach, const Progress* progress) {
    if (reach > 0.0) {
        CrackClosing(draft, reach, progress).run();
    }
}

}  // namespace mq::boolean
