// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "mesh/constrained_triangulation.h"

namespace mq::triangulate {

/// Points of the plane, with exact predicates.
struct PlanePoints {
    std::vector<Vec2> points;

    int orient(int a, int b, int c) const;
    bool ahead(int a, int b, int c) const;
    [[noreturn]] static void outside();
    static std::array<mesh::NumberedTriangle, 2> flipped(int t, int o, const std::array<int, 4>& v) {
        return {{{t, {v[0], v[3], v[2]}}, {o, {v[3], v[1], v[2]}}}};
    }
    static std::array<mesh::NumberedTriangle, 2> divided(int t, int n, const std::array<int, 4>& v) {
        return {{{t, {v[2], v[0], v[3]}}, {n, {v[1], v[2], v[3]}}}};
    }
    static std::array<int, 4> suspects(int t, int o) { return {t, t + 2, o, o + 1}; }
    static unsigned examined(unsigned turn, unsigned k) { return (k + turn) % 3; }
};

/// Constrained Delaunay triangulation in the plane, incremental, with exact predicates.
///
/// Two large triangles around `box` form a frame; the caller distinguishes inside from outside by its constraints.
class ConstrainedDelaunay : public mesh::ConstrainedTriangulation<PlanePoints> {
  public:
    /// Every point inserted later must lie in the box [low, high].
    /// @param expected  points for which memory is set aside
    ConstrainedDelaunay(const Vec2& low, const Vec2& high, std::size_t expected = 0);

    /// Inserts a point and restores the Delaunay property. Returns the existing vertex if the point is there already.
    /// A point on a constraint splits it; both halves keep its label.
    int insert(const Vec2& p) { return insert(p, false); }
    /// As `insert`, but refuses a point on a constraint: -1.
    int insert_off_constraints(const Vec2& p) { return insert(p, true); }

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

    int vertex_count() const { return static_cast<int>(out_.size()); }
    const Vec2& point(int v) const { return points_.points[v]; }
    /// Vertices 0..3 are the frame's corners.
    static constexpr int kFrame = 4;

  private:
    int insert(const Vec2& p, bool off_constraints);
    void legalise();

    // Triangle where the last search ended, where the next one begins: successive points are often close.
    int last_ = 0;
};

}  // namespace mq::triangulate
