// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/exact/exact_point.h"
#include "mesh/constrained_triangulation.h"

namespace mq::boolean {

/// The line of a constraint within its plane: either an edge between two given points, or the cut by another plane.
struct Line {
    bool edge = false;
    Vec3 from = Vec3::Zero();  ///< ends, for an edge
    Vec3 to = Vec3::Zero();
    PlanePoints plane;  ///< the other plane, for a cut
};

/// Exact points of one plane, which is seen along one of the axes.
struct PointsOfPlane {
    int axis;
    int turn;  ///< -1 when the plane's triangles then run clockwise
    std::vector<ExactPoint> points;

    int orient(int a, int b, int c) const;
    bool ahead(int a, int b, int c) const;
    [[noreturn]] static void outside();
    static std::array<mesh::NumberedTriangle, 2> flipped(int t, int o, const std::array<int, 4>& v) {
        return {{{t, {v[3], v[1], v[2]}}, {o, {v[2], v[0], v[3]}}}};
    }
    static std::array<mesh::NumberedTriangle, 2> divided(int t, int n, const std::array<int, 4>& v) {
        return {{{n, {v[3], v[1], v[2]}}, {t, {v[0], v[3], v[2]}}}};
    }
    static std::array<int, 2> suspects(int t, int o) { return {t, o + 1}; }
    static unsigned examined(unsigned /*turn*/, unsigned k) { return 2 - k; }
};

/// A triangulation of exact points of one plane in which given segments become edges. Segments may cross: the crossing
/// becomes a point. Topology and predicates are exact.
class ExactConstrainedTriangulation : public mesh::ConstrainedTriangulation<PointsOfPlane> {
  public:
    /// A plane that thousands of others cut takes long: every function looks for a cancellation.
    /// @param plane the plane's points, seen along `axis`
    /// @param turn -1 when the plane's triangles then run clockwise
    ExactConstrainedTriangulation(const PlanePoints& plane, int axis, int turn, const Progress* progress = nullptr)
        : ConstrainedTriangulation({axis, turn, {}}, progress), plane_(plane) {}

    /// Adds a point without a place in the triangulation yet; returns its index here.
    int add_point(ExactPoint point) { return add_vertex(std::move(point)); }
    /// Begins with one triangle, which runs counter-clockwise.
    void start(int a, int b, int c) { add_triangle(a, b, c); }
    /// Puts a point on the edge from a to b, in its inside.
    void split_edge(int a, int b, int point);
    /// Inserts a point, and swaps edges around it that are no constraints where that enlarges the smallest angle, so
    /// that vertices have few edges and walks are short. Returns the point, or the one that was in its place.
    int insert(int point);
    /// Makes the segment from a to b a chain of edges; points on it divide it.
    void constrain(int a, int b, int line);
    int add_line(const Line& line);

    /// Swaps edges that are no constraints where that enlarges the smallest angle.
    void improve();

    /// Triangles of point indices, counter-clockwise.
    std::vector<std::array<int, 3>> triangles() const;
    const std::vector<ExactPoint>& points() const { return points_.points; }
    /// Whether a point lies in the closed triangle a, b, c (counter-clockwise).
    bool in_triangle(int point, int a, int b, int c) const;

  private:
    int split_at_crossing(int h, int line);
    bool better_flipped(int h) const;

    PlanePoints plane_;
    std::vector<Line> lines_;
};

}  // namespace mq::boolean
