// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "mesh/corner_table.h"

namespace mq::triangulate {

/// Constrained Delaunay triangulation in the plane, incremental, with exact predicates.
///
/// Two large triangles around `box` form a frame; the caller distinguishes inside from outside by its constraints.
/// Half-edge 3 t + i runs from corner i to corner i + 1 of triangle t, counter-clockwise.
class ConstrainedDelaunay {
  public:
    /// Every point inserted later must lie in the box [low, high].
    /// @param expected  points for which memory is set aside
    ConstrainedDelaunay(const Vec2& low, const Vec2& high, std::size_t expected = 0);

    /// Inserts a point and restores the Delaunay property. Returns the existing vertex if the point is there already.
    /// A point on a constraint splits it; both halves keep its label.
    int insert(const Vec2& p);
    /// As `insert`, but refuses a point on a constraint: -1.
    int insert_off_constraints(const Vec2& p);

    /// The obstacle to a constraint.
    struct Obstacle {
        int vertex = -1;      ///< a vertex in the interior of the constraint, or -1
        int constraint = -1;  ///< the label of a constraint that it would cross, or -1
    };
    /// Makes a-b an edge with the label, or names the first obstacle and leaves the constraints as they were.
    std::optional<Obstacle> insert_constraint(int a, int b, int label);

    /// Replaces an edge by the other diagonal of its two triangles, whether Delaunay or not.
    /// @return false: not done, at constraints, at the frame, and if the two triangles form no strictly convex
    /// quadrangle.
    bool flip_edge(int h);

    int triangle_count() const { return static_cast<int>(corner_.size() / 3); }
    int vertex_count() const { return static_cast<int>(points_.size()); }
    const Vec2& point(int v) const { return points_[v]; }
    int corner(int h) const { return corner_[h]; }
    int twin(int h) const { return twin_[h]; }    ///< -1 on the frame
    int label(int h) const { return label_[h]; }  ///< label of the constraint on the edge, or -1
    static int next(int h) { return mesh::next_corner(h); }
    static int prev(int h) { return mesh::previous_corner(h); }
    /// The half-edge from a to b, or -1.
    int find_edge(int a, int b) const;
    /// Vertices 0..3 are the frame's corners.
    static constexpr int kFrame = 4;

  private:
    struct Place {
        int half_edge;  // p lies on it (on_edge) or in its triangle
        bool on_edge;
        int vertex;  // p is this vertex, or -1
    };
    Place locate(const Vec2& p) const;
    int insert_at(const Place& place, const Vec2& p);
    void set_triangle(int t, int a, int b, int c);
    void attach(int h, int g, int label);
    void insert_in_triangle(int t, int v);
    void insert_on_edge(int h, int v);
    void flip(int h);
    void legalise();
    bool crosses(int a, int b, int h) const;
    std::optional<Obstacle> collect_crossings(int a, int b, std::vector<std::array<int, 2>>& crossed) const;
    void remove_crossings(int a, int b, std::vector<std::array<int, 2>> crossed);

    std::vector<Vec2> points_;
    std::vector<int> corner_;
    std::vector<int> twin_;
    std::vector<int> label_;
    std::vector<int> half_edge_of_;  // by vertex: a half-edge that leaves it
    std::vector<int> suspects_;      // half-edges that may not be Delaunay, see legalise
    // Triangle where the last search ended, where the next one begins: successive points are often close.
    int last_ = 0;
};

}  // namespace mq::triangulate
