// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <vector>

namespace mq::mesh {

/// The *star* of each vertex of a mesh that is edited: the triangles or tetrahedra that have it, in ascending order.
/// The mesh itself holds the list of simplices: arrays of vertices, or structures with such an array `corners`.
class SimplexStars {
  public:
    explicit SimplexStars(std::size_t vertices = 0) : stars_(vertices) {}

    /// Vertices that are left out have no simplices.
    void resize(std::size_t vertices) { stars_.resize(vertices); }
    const std::vector<int>& operator[](int v) const { return stars_[static_cast<std::size_t>(v)]; }

    template <typename Simplex>
    void add(int simplex, const Simplex& corners) {
        for (const int v : corners) {
            std::vector<int>& star = stars_[static_cast<std::size_t>(v)];
            star.insert(std::upper_bound(star.begin(), star.end(), simplex), simplex);
        }
    }
    template <typename Simplex>
    void remove(int simplex, const Simplex& corners) {
        for (const int v : corners) {
            std::vector<int>& star = stars_[static_cast<std::size_t>(v)];
            star.erase(std::lower_bound(star.begin(), star.end(), simplex));
        }
    }

    /// The simplices that have all of some vertices, in ascending order.
    template <typename Simplices>
    std::vector<int> of(std::initializer_list<int> vertices, const Simplices& simplices) const {
        std::vector<int> found;
        const std::vector<int>& star = smallest(vertices);
        std::copy_if(star.begin(), star.end(), std::back_inserter(found),
                     [&](int t) { return has_all(corners_of(simplices, t), vertices); });
        return found;
    }
    /// Whether an edge joins two vertices.
    template <typename Simplices>
    bool joined(int a, int b, const Simplices& simplices) const {
        const std::vector<int>& star = smallest({a, b});
        return std::any_of(star.begin(), star.end(), [&](int t) { return has_all(corners_of(simplices, t), {a, b}); });
    }
    /// The other vertices of the simplices that have all of some vertices, in ascending order.
    template <typename Simplices>
    std::vector<int> link(std::initializer_list<int> vertices, const Simplices& simplices) const {
        std::vector<int> found;
        for (const int t : smallest(vertices)) {
            if (has_all(corners_of(simplices, t), vertices)) {
                std::copy_if(corners_of(simplices, t).begin(), corners_of(simplices, t).end(),
                             std::back_inserter(found), [&](int v) { return !has(vertices, v); });
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }
    /// The link condition, under which the collapse of edge (a, b) keeps the mesh a manifold: only the vertices in the
    /// link of the edge are joined to both of its ends. Two triangles with the same vertices at the edge violate it.
    template <typename Simplices>
    bool link_condition(int a, int b, const Simplices& simplices) const {
        const std::vector<int> edge_link = link({a, b}, simplices);
        const std::vector<int> at_edge = of({a, b}, simplices);
        if (!at_edge.empty() && corners_of(simplices, at_edge[0]).size() == 3 && at_edge.size() != edge_link.size()) {
            return false;
        }
        const bool fewer_at_a = (*this)[a].size() <= (*this)[b].size();
        const int other = fewer_at_a ? b : a;
        const std::vector<int> around = link({fewer_at_a ? a : b}, simplices);
        return std::none_of(around.begin(), around.end(), [&](int v) {
            return v != other && !std::binary_search(edge_link.begin(), edge_link.end(), v) &&
                   joined(v, other, simplices);
        });
    }

  private:
    template <std::size_t N>
    static const std::array<int, N>& corners_of(const std::vector<std::array<int, N>>& simplices, int t) {
        return simplices[static_cast<std::size_t>(t)];
    }
    template <typename Simplex>
    static const auto& corners_of(const std::vector<Simplex>& simplices, int t) {
        return simplices[static_cast<std::size_t>(t)].corners;
    }
    template <typename Vertices>
    static bool has(const Vertices& vertices, int v) {
        return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
    }
    template <typename Simplex>
    static bool has_all(const Simplex& corners, std::initializer_list<int> vertices) {
        return std::all_of(vertices.begin(), vertices.end(), [&](int v) { return has(corners, v); });
    }
    /// A vertex in the middle of a fan may have thousands of triangles, the others of the fan have few.
    const std::vector<int>& smallest(std::initializer_list<int> vertices) const {
        return (*this)[*std::min_element(vertices.begin(), vertices.end(),
                                         [&](int a, int b) { return (*this)[a].size() < (*this)[b].size(); })];
    }

    std::vector<std::vector<int>> stars_;
};

}  // namespace mq::mesh
